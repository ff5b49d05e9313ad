# A second run does only what is left to do, and what it does is the same to the bit.

times() { stat -c '%n %y' out/*.exr; }

# Frames whose files differ between the lists of times in the files a and b, by number
changed() { diff <(cat a) <(cat b) | sed -n 's/^> .*[.]\([0-9]*\)[.]exr .*/\1/p' | tr '\n' ' '; }

case_only_missing_and_broken_frames_are_rendered() {
    small_shot
    run render shot.yaml
    expect_exit 0
    expect_match stderr '^out: 6 of 6 frames rendered, 0 kept, in '
    cp -r out first
    times >a
    rm out/shot.0002.exr out/shot.0006.exr
    local bytes=$((RANDOM * RANDOM % $(stat -c %s out/shot.0004.exr)))
    truncate -s "$bytes" out/shot.0004.exr
    run render shot.yaml
    expect_exit 0
    expect_line stderr '3 frames are complete already'
    expect_match stderr '^out: 3 of 6 frames rendered, 3 kept, in '
    times >b
    expect_equal "rendered again (frame 4 had been cut to $bytes bytes)" "$(changed)" '0002 0004 0006 '
    local frame
    for frame in first/*.exr; do expect_same_frames "$frame" "out/${frame#first/}"; done
    run render shot.yaml
    expect_match stderr '^out: 0 of 6 frames rendered, 6 kept, in '
}

case_a_changed_shot_is_rendered_again() {
    small_shot
    run render shot.yaml
    run render shot.yaml --set look.sun.azimuth_deg=90 --frames 1-2
    expect_exit 0
    expect_line stderr '2 frames are of an earlier version of the shot and are rendered again'
    run render shot.yaml --set look.sun.azimuth_deg=90
    expect_line stderr '2 frames are complete already'
    expect_line stderr '4 frames are of an earlier version of the shot and are rendered again'
}

case_what_does_not_change_pixels_keeps_frames() {
    small_shot
    run render shot.yaml
    mv shot.yaml renamed.yaml
    mv terrain.yaml ground.yaml
    sed -i 's/terrain[.]yaml/ground.yaml/' renamed.yaml
    echo 'description: only words' >>renamed.yaml
    run render renamed.yaml --threads 1
    expect_match stderr '^out: 0 of 6 frames rendered, 6 kept, in '
}

case_a_foreign_file_under_a_frames_name() {
    small_shot
    mkdir out
    echo 'no picture' >out/shot.0001.exr
    : >out/shot.0002.exr
    run render shot.yaml
    expect_exit 0
    expect_match stderr '^out: 6 of 6 frames rendered, 0 kept, in '
    expect_clean_folder out
}

case_any_choice_of_frames_gives_the_same_pixels() {
    small_shot
    run render shot.yaml --set sampling.lines=2
    run render shot.yaml --set sampling.lines=2 --frames 3-4 -o some
    expect_exit 0
    expect_equal 'frames' "$(ls some)" "$(printf 'manifest.json\nshot.0003.exr\nshot.0004.exr')"
    run render shot.yaml --set sampling.lines=2 --frames 1-6:5 -o ends
    expect_same_frames out/shot.0003.exr some/shot.0003.exr
    expect_same_frames out/shot.0004.exr some/shot.0004.exr
    expect_same_frames out/shot.0001.exr ends/shot.0001.exr
    expect_same_frames out/shot.0006.exr ends/shot.0006.exr
    # That the comparison can fail:
    expect test "$("$OVERFLY_PROBE" same out/shot.0001.exr out/shot.0006.exr && echo same)" != same
}

case_any_number_of_threads_gives_the_same_pixels() {
    small_shot
    local tracer
    for tracer in interval discrete; do
        run render shot.yaml --tracer "$tracer" --samples 4 --frames 1-5:4 --threads 1 -o "one_$tracer"
        expect_exit 0
        run render shot.yaml --tracer "$tracer" --samples 4 --frames 1-5:4 --threads 2 -o "two_$tracer"
        expect_same_frames "one_$tracer/shot.0001.exr" "two_$tracer/shot.0001.exr"
        expect_same_frames "one_$tracer/shot.0005.exr" "two_$tracer/shot.0005.exr"
    done
}

case_numbers_from_a_first_frame_on() {
    small_shot
    run render shot.yaml
    run render shot.yaml --set frames.first=1001 -o later
    expect_equal 'first' "$(ls later/*.exr | head -1)" later/shot.1001.exr
    expect_same_frames out/shot.0001.exr later/shot.1001.exr
}
