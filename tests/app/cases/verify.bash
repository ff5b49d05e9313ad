# Whether a sequence is complete and sound, and its manifest.

rendered() {
    small_shot
    run render shot.yaml "$@"
    expect_exit 0
}

verify_finds() {  # verify_finds LINE...: these bad frames and no others, in a sequence of six
    run verify out
    expect_exit 2
    expect_equal 'bad frames' "$(cat stderr)" "$(printf '%s\n' "$@")"
    expect_line stdout "shot: $((6 - $#)) of 6 frames are sound and as the manifest lists them"
}

repairs() {  # repairs RENDERED: afterwards all is as it was in the folder `first`
    run render shot.yaml --repair --json
    expect_exit 0
    expect_equal 'rendered' "$(json /frames/rendered)" "$1"
    run verify out
    expect_exit 0
    expect_line stdout 'shot: 6 of 6 frames are sound and as the manifest lists them'
    local frame
    for frame in first/*.exr; do expect_same_frames "$frame" "out/${frame#first/}"; done
}

case_sound() {
    rendered
    run verify out
    expect_exit 0
    expect_empty stderr
    expect_equal 'says' "$(cat stdout)" 'shot: 6 of 6 frames are sound and as the manifest lists them'
    run verify out --json
    expect_exit 0
    expect_equal 'sound' "$(json /sound)" true
    expect_equal 'sequence' "$(json /sequences/0/name) $(json /sequences/0/manifest) $(json /sequences/0/frames)" 'shot true 6'
    expect_equal 'bad' "$(json /sequences/0/bad)" '[]'
}

case_missing_truncated_and_unreadable_frames() {
    rendered
    cp -r out first
    rm out/shot.0001.exr out/shot.0006.exr
    truncate -s 3000 out/shot.0002.exr
    : >out/shot.0003.exr
    head -c 5000 /dev/urandom >out/shot.0004.exr
    run verify out --json
    expect_exit 2
    local i faults=
    for i in 0 1 2 3 4; do faults+="$(json /sequences/0/bad/$i/number) $(json /sequences/0/bad/$i/fault), "; done
    expect_equal 'faults' "$faults" '1 missing, 2 truncated, 3 truncated, 4 unreadable, 6 missing, '
    expect_line stderr 'out/shot.0001.exr: missing'
    expect_line stderr "out/shot.0003.exr: can't be read as a frame: it is cut off"
    run verify out --frames 5
    expect_exit 0
    repairs 5
}

# A file that OpenEXR reads without complaint, but with other pixels.
case_other_pixels() {
    rendered
    cp -r out first
    "$OVERFLY_PROBE" change out/shot.0003.exr R 0.99
    verify_finds 'out/shot.0003.exr: its pixels are not those that the manifest lists'
    # Without --repair what can be read is kept, and the manifest goes on saying what was rendered.
    run render shot.yaml
    expect_match stderr '^out: 0 of 6 frames rendered, 6 kept, in '
    verify_finds 'out/shot.0003.exr: its pixels are not those that the manifest lists'
    repairs 1
}

case_black_duplicated_and_infinite_frames() {
    rendered
    cp -r out first
    rm out/manifest.json  # else other pixels are all that it says
    local channel
    for channel in R G B; do "$OVERFLY_PROBE" change out/shot.0001.exr $channel 0; done
    "$OVERFLY_PROBE" change out/shot.0002.exr A 0
    "$OVERFLY_PROBE" change out/shot.0003.exr Z inf
    cp out/shot.0004.exr out/shot.0005.exr
    # The pixels of one frame in the file of another.
    "$OVERFLY_PROBE" pixels_of out/shot.0004.exr out/shot.0006.exr
    run verify out
    expect_exit 2
    expect_line stderr 'out/shot.0001.exr: it is black or transparent throughout'
    expect_line stderr 'out/shot.0002.exr: it is black or transparent throughout'
    expect_line stderr 'out/shot.0003.exr: 2304 of its values are infinite or no numbers, the first of channel Z'
    expect_line stderr 'out/shot.0005.exr: it is frame 4 by its header'
    expect_line stderr 'out/shot.0006.exr: it has the pixels of shot.0004.exr, though the camera has moved'
    expect_match stderr '^note: no manifest lists shot[.]'
    expect_line stdout 'shot: 1 of 6 frames are sound by themselves'
    repairs 5
}

case_a_camera_at_rest_repeats_its_picture() {
    small_shot
    sed -i 's/lon_deg: -105.51, lat_deg: 37.612, height_m: 4800, heading_deg: 150, pitch_deg: -14/lon_deg: -105.53, lat_deg: 37.620, height_m: 4700, heading_deg: 140, pitch_deg: -12/' flight.yaml
    run render shot.yaml --set sampling.tracer=discrete --set shutter.angle_deg=0
    run verify out
    expect_exit 0
}

case_frames_of_two_versions() {
    rendered
    run render shot.yaml --set look.sun.azimuth_deg=90 --frames 1-2
    run verify out
    expect_exit 2
    expect_equal 'bad' "$(cat stderr)" "$(printf 'out/shot.000%s.exr: it is of another version of the shot\n' 3 4 5 6)"
    run verify out --frames 1-2
    expect_exit 0
}

case_without_a_manifest() {
    rendered
    rm out/manifest.json out/shot.0003.exr
    run render shot.yaml --frames 4 --set image.width=32 -o small
    mv small/shot.0004.exr out
    run verify out
    expect_exit 2
    expect_line stderr 'out/shot.0003.exr: missing'
    expect_line stderr 'out/shot.0004.exr: it has 32 x 36 pixels instead of 64 x 36 as most others'
    run verify nothing
    refused "nothing: can't be read as a folder: No such file or directory"
    mkdir empty
    run verify empty
    refused 'empty: has no frames, NAME.0001.exr, and no manifest.json'
    echo '{"format": "something"}' >out/manifest.json
    run verify out
    expect_exit 2
    expect_match stderr '^out/manifest.json: can.t be read as a manifest: '
}

case_two_shots_in_one_folder() {
    small_shot a
    small_shot b
    run batch a.yaml b.yaml
    rm out/b.0002.exr
    run verify out
    expect_exit 2
    expect_equal 'bad' "$(cat stderr)" 'out/b.0002.exr: missing'
    expect_line stdout 'a: 6 of 6 frames are sound and as the manifest lists them'
    expect_line stdout 'b: 5 of 6 frames are sound and as the manifest lists them'
}

manifest() { "$OVERFLY_PROBE" json "$1" <out/manifest.json; }

case_what_the_manifest_says() {
    rendered --set look.sun.azimuth_deg=90
    local shot=/sequences/shot
    expect_equal 'command' "$(manifest $shot/command)" '["overfly","render","shot.yaml","--set","look.sun.azimuth_deg=90"]'
    expect_equal 'frames' "$(manifest $shot/first) $(manifest $shot/count)" '1 6'
    expect_equal 'file' "$(manifest $shot/frames/2/file)" shot.0003.exr
    expect_near 'time' "$(manifest $shot/frames/2/time_s)" 0.083333 0.000001
    expect_equal 'size' "$(manifest $shot/frames/2/size_bytes)" "$(stat -c %s out/shot.0003.exr)"
    expect_equal 'alpha' "$(manifest $shot/frames/2/statistics/mean_alpha)" 1.0
    expect_equal 'input' "$(manifest $shot/inputs/files/0/what) $(manifest $shot/inputs/files/0/file)" 'shot ../shot.yaml'
    expect_equal 'hash of it' "$(manifest $shot/inputs/files/0/sha256)" "$(sha256sum <shot.yaml | cut -d' ' -f1)"
    expect_equal 'raster' "$(manifest $shot/inputs/files/3/what) $(manifest $shot/inputs/files/3/file)" 'elevation ../dem.tif'
    expect_equal 'hash of it' "$(manifest $shot/inputs/files/3/sha256)" "$(sha256sum <dem.tif | cut -d' ' -f1)"
    expect_equal 'CRS' "$(manifest $shot/terrain/crs)" 'WGS 84 / UTM zone 13N (EPSG:32613)'
    expect_equal 'datum' "$(manifest $shot/terrain/vertical_datum)" 'EGM96 geoid (stated)'
    expect_near 'mesh' "$(manifest $shot/mesh_error/largest_px)" 0.25 0.25
    expect_near 'motion' "$(manifest $shot/motion_error/largest_px)" 0.005 0.005
    expect_match <(manifest $shot/libraries/OpenEXR) '^[0-9.]+$'
    expect_equal 'pixels' "$(manifest $shot/frames/2/pixels_sha256)" \
        "$("$OVERFLY_PROBE" hashed_bytes out/shot.0003.exr | sha256sum | cut -d' ' -f1)"
}

case_a_manifest_that_is_gone_or_broken_is_made_anew() {
    rendered
    cp out/manifest.json before
    stat -c '%n %y' out/* >times
    run render shot.yaml
    expect_equal 'nothing is written' "$(stat -c '%n %y' out/*)" "$(cat times)"
    local hashes
    hashes=$(grep pixels_sha256 before)
    rm out/manifest.json
    run render shot.yaml
    expect_match stderr '^out: 0 of 6 frames rendered, 6 kept, in '
    expect_equal 'hashes' "$(grep pixels_sha256 out/manifest.json)" "$hashes"
    head -c 700 before >out/manifest.json
    run render shot.yaml
    expect_line stderr "the manifest can't be read and is made anew from the frames"
    expect_equal 'hashes' "$(grep pixels_sha256 out/manifest.json)" "$hashes"
    run verify out
    expect_exit 0
}

# What a killed run leaves is a manifest of complete frames, and the next run completes it.
case_killed_while_rendering() {
    small_shot
    sed -i 's/count: 6/rate: 48/; s/lines: 1/lines: 16/' shot.yaml
    "$OVERFLY" render shot.yaml >stdout 2>stderr &
    local render=$!
    wait_until 100 test -e out/manifest.json
    kill -KILL "$render"
    wait "$render" || true
    run verify out --json
    expect_exit 2
    local i number
    for ((i = 0; ; ++i)); do
        number=$("$OVERFLY_PROBE" json "/sequences/shot/frames/$i/number" <out/manifest.json 2>probe) || break
        expect_no_match stdout "\"number\": $number,"
    done
    expect test "$i" -gt 0
    run render shot.yaml --frames "1-$((i + 1))"
    expect_exit 0
    run verify out --frames "1-$((i + 1))"
    expect_exit 0
}
