# overfly path: numbers against closed form.

# A level flight along a circle of latitude, which two keyframes a kilometre apart are near enough to.
level_flight() {
    cat >flight.yaml <<'END'
height_above: ellipsoid
lens: {hfov_deg: 60}
keyframes:
  - {time_s: 0, lon_deg: -105.50, lat_deg: 37.6, height_m: 5000, heading_deg: 90, pitch_deg: -10}
  - {time_s: 5, lon_deg: -105.49, lat_deg: 37.6, height_m: 5000, heading_deg: 90, pitch_deg: -10}
  - {time_s: 10, lon_deg: -105.48, lat_deg: 37.6, height_m: 5000, heading_deg: 90, pitch_deg: -10}
END
}

case_level_straight_flight() {
    small_shot
    level_flight
    run path flight.yaml --terrain terrain.yaml --json
    expect_exit 0
    expect_empty stderr
    # Radius of curvature across the meridian plus height, times the cosine of the latitude, times 0.02 degrees.
    local length_m
    length_m=$(awk 'BEGIN { r = atan2(0, -1) / 180; f = 1 / 298.257223563; e2 = f * (2 - f); s = sin(37.6 * r);
        printf "%.6f", (6378137 / sqrt(1 - e2 * s * s) + 5000) * cos(37.6 * r) * 0.02 * r }')
    expect_near 'duration' "$(json /duration_s)" 10 1e-9
    expect_near 'length' "$(json /length_m)" "$length_m" 0.1
    expect_near 'mean speed' "$(json /mean_m_per_s)" "$(awk "BEGIN { print $length_m / 10 }")" 0.01
    expect_near 'climb' "$(json /climb_m)" 0 0.01
    expect_near 'roll' "$(json /fastest_roll_deg_per_s/value)" 0 1e-3
    expect_near 'pitch' "$(json /fastest_pitch_deg_per_s/value)" 0 1e-3
    expect_near 'off the terrain' "$(json /off_terrain_share)" 0 0
    expect_match stdout '"clearance_m": [0-9.]+'
    expect_match stdout '"lon_deg": -105[.]4'
}

case_report_for_people() {
    small_shot
    run path shot.yaml
    expect_exit 0
    expect_empty stderr
    local what
    for what in duration length climb 'speed, mean' 'lowest clearance' 'fastest turn' motion; do
        expect_match stdout "^$what  +[0-9]"
    done
    expect_match stdout '^motion +[0-9]+ pieces, 0[.]0[0-9]+ px from the exact path at most \(bound 0[.]01 px\)$'
    run path shot.yaml --json
    expect_near 'motion is within its bound' "$(json /motion/largest_error_px)" 0.005 0.005
}

case_flight_without_terrain() {
    small_shot
    run path flight.yaml
    refused 'flight.yaml: a flight is checked over a terrain: add --terrain terrain/NAME.yaml, or name the shot that joins the two'
    run path terrain.yaml
    refused 'terrain.yaml: a flight or a shot document is wanted here'
}

case_demo_flight() {
    run path "$project/configs/demo.yaml" --json
    expect_exit 0
    expect_near 'at least 96 frames at 24 per second' "$(json /duration_s)" 6 2
    expect_equal 'above the ground' "$(awk "BEGIN { print ($(json /lowest_clearance/clearance_m) > 20) }")" 1
}
