# Documents and values that are wrong: one line for each problem, exit code 2, and nothing rendered (section 7 of the first
# flight's issue). What YAML can get wrong line by line is tested in tests/bad_input.

# refused_before_rendering LINE...
refused_before_rendering() {
    refused "$@"
    expect test ! -e out
}

case_keyframe_off_the_terrain() {
    small_shot
    run render shot.yaml --set flight.height_above=ground --set flight.keyframes.0.height_m=500 \
        --set flight.keyframes.1.height_m=500 --set flight.keyframes.0.lon_deg=-100
    refused_before_rendering "flight.yaml:4:5: keyframes[0]: lon -100.000000, lat 37.620000: height is counted from the\
 ground, but there is no terrain; move the camera onto the terrain or count from sea level or the ellipsoid"
}

case_keyframe_under_the_ground() {
    small_shot
    run render shot.yaml --set flight.keyframes.1.height_m=1000
    expect_match stderr '^flight.yaml:5:5: keyframes\[1\]: lon -105.510000, lat 37.612000: the camera is [0-9.]+ m below the ground; must be above it \(the ground is at [0-9.]+ m above the ellipsoid\)$'
    refused_before_rendering "$(cat stderr)"
    expect_equal 'lines' "$(wc -l <stderr)" 1
}

case_times_not_increasing() {
    small_shot
    run render shot.yaml --set flight.keyframes.0.time_s=1
    refused_before_rendering \
        'flight.yaml:5:14: keyframes.1.time_s: got 1, allowed more than 1, the time of the keyframe before'
}

case_empty_frame_range() {
    small_shot
    run render shot.yaml --frames 5-3
    refused_before_rendering \
        '--frames 5-3: got 5-3, which is empty, allowed a first frame that is not after the last'
}

case_frames_that_the_shot_does_not_have() {
    small_shot
    run render shot.yaml --frames 5-30
    refused_before_rendering '--frames 5-30: got 5-30, allowed frames 1 to 6'
}

case_no_frames_at_all() {
    small_shot
    run render shot.yaml --set frames.count=0
    refused_before_rendering '--set frames.count=0: frames.count: got 0, allowed 1 to 10000000'
    sed -i 's/count: 6/start_s: 2/' shot.yaml
    run render shot.yaml
    refused_before_rendering 'shot.yaml: frames.start_s: got 2, but the flight lasts 1.000 s; no frame is left'
}

case_image_of_0_pixels() {
    small_shot
    sed -i 's/width: 64/width: 0/' shot.yaml
    run render shot.yaml
    refused_before_rendering 'shot.yaml:4:16: image.width: got 0, allowed 1 to 65536'
}

case_misspelt_key() {
    small_shot
    sed -i 's/height: 36/hieght: 36/' shot.yaml
    run render shot.yaml
    refused_before_rendering \
        "shot.yaml:4:20: unknown key 'hieght' in 'image'; did you mean 'height'? known: width, height, transparent_sky,\
 filter, filter_width_px"
}

case_several_problems_at_once_in_several_documents() {
    small_shot
    sed -i 's/width: 64/width: wide/' shot.yaml
    sed -i 's/hfov_deg: 60/hfov_deg: 180/' flight.yaml
    echo 'vertcal_unit: m' >>terrain.yaml
    run render shot.yaml
    expect_exit 2
    expect_equal 'problems' "$(wc -l <stderr)" 3
    expect_match stderr '^shot.yaml:4:16: image.width: got .wide., allowed '
    expect_match stderr '^flight.yaml:2:18: lens.hfov_deg: got 180, allowed '
    expect_match stderr "^terrain.yaml:3:1: unknown key 'vertcal_unit'; did you mean 'vertical_unit'[?] known: "
    expect test ! -e out
}

case_set_with_an_unknown_key() {
    small_shot
    run render shot.yaml --set image.widht=3
    refused_before_rendering "--set image.widht=3: unknown key 'widht' in 'image'; did you mean 'width'? known: width,\
 height, transparent_sky, filter, filter_width_px"
}

case_set_without_a_value() {
    small_shot
    run render shot.yaml --set image.width
    refused_before_rendering '--set image.width: got no key and value, allowed key.subkey=value'
}

case_missing_documents() {
    run render nothing.yaml
    refused 'nothing.yaml: no such file'
    small_shot
    rm terrain.yaml
    run render shot.yaml
    refused_before_rendering \
        "shot.yaml:1:10: terrain: got 'terrain.yaml', allowed a file that exists; there is no 'terrain.yaml'"
}

case_a_document_of_another_kind() {
    small_shot
    echo 'shots: shot.yaml' >batch.yaml
    run render flight.yaml
    refused 'flight.yaml: this is a flight document; a shot document is wanted here, configs/NAME.yaml'
    run render terrain.yaml
    refused 'terrain.yaml: this is a terrain document; a shot document is wanted here, configs/NAME.yaml'
    run render batch.yaml
    refused 'batch.yaml: this is a batch document; render it with overfly batch'
}

case_flight_under_the_ground_between_its_keyframes() {
    small_shot
    cat >flight.yaml <<'END'
height_above: sea_level
lens: {hfov_deg: 60}
keyframes:
  - {time_s: 0, lon_deg: -105.53, lat_deg: 37.5772, height_m: 4100, heading_deg: 90, pitch_deg: 0}
  - {time_s: 1, lon_deg: -105.44, lat_deg: 37.5772, height_m: 4100, heading_deg: 90, pitch_deg: 0}
END
    run path shot.yaml
    expect_exit 2
    expect_equal 'lines of standard error' "$(wc -l <stderr)" 1
    expect_match stderr '^flight.yaml: the flight goes [0-9.]+ m below the ground at 0[.][0-9]+ s, between its keyframes; raise or add a keyframe there$'
    expect_match stdout '^lowest clearance +-[0-9.]+ m at 0[.]'
    # Rendering shows what was asked for, but says so.
    run render shot.yaml --set frames.count=24 --frames 10-15
    expect_exit 0
    expect_match stderr '^note: in [1-6] of 6 frames, the first is [0-9]+, the camera is below the ground$'
}
