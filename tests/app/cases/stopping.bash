# A run that is stopped or killed leaves complete frames and nothing else; the next one goes on.

# A render that takes long enough to be stopped in the middle, in the background; its process id is in $render.
start_long_render() {
    small_shot
    sed -i 's/count: 6/rate: 48/; s/lines: 1/lines: 16/' shot.yaml
    "$OVERFLY" render shot.yaml >stdout 2>stderr &
    render=$!
}

has_frames() { compgen -G 'out/*.exr' >/dev/null; }

wait_for_render() {
    exit_code=0
    wait "$render" || exit_code=$?
}

frame_count() { find out -name 'shot.*.exr' | wc -l; }

# How a run ends that a signal asked to stop, and that the next one finishes.
stopped_by() {  # stopped_by SIGNAL
    start_long_render
    wait_until 100 has_frames
    kill "-$1" "$render"
    wait_for_render
    expect_exit 130
    expect_line stderr 'stopped; what was finished is complete, and a second run goes on from there'
    expect_empty stdout
    expect_clean_folder out
    local complete
    complete=$(frame_count)
    expect test "$complete" -gt 0
    expect test "$complete" -lt 48
    run render shot.yaml --frames "1-$((complete + 1))" --json
    expect_exit 0
    expect_equal 'kept' "$(json /frames/kept)" "$complete"
    expect_equal 'rendered' "$(json /frames/rendered)" 1
}

case_interrupt() { stopped_by INT; }
case_terminate() { stopped_by TERM; }

case_interrupt_before_the_first_frame() {
    small_shot
    sed -i 's/lines: 1/lines: 96/' shot.yaml
    "$OVERFLY" render shot.yaml >stdout 2>stderr &
    render=$!
    wait_until 60 test -d out
    kill -INT "$render"
    wait_for_render
    expect_exit 130
    expect_equal 'files' "$(ls -A out)" ''
}

case_kill() {
    start_long_render
    wait_until 100 has_frames
    kill -KILL "$render"
    wait_for_render
    expect_exit 137
    local frame
    for frame in out/shot.*.exr; do expect "$OVERFLY_PROBE" complete "$frame"; done
}

# What a killed run was writing has a hidden name with its machine and process id in it.
case_leftovers_of_a_killed_run_are_removed() {
    small_shot
    mkdir out
    local dead gone alive elsewhere
    sleep 0 &
    dead=$!
    wait "$dead"
    gone=out/.shot.0002.exr.tmp-$(uname -n)-$dead-0123abcd
    alive=out/.shot.0003.exr.tmp-$(uname -n)-$$-0123abcd
    elsewhere=out/.shot.0004.exr.tmp-another-machine-$dead-0123abcd
    touch "$gone" "$alive" "$elsewhere" out/.mine
    run render shot.yaml
    expect_exit 0
    expect test ! -e "$gone"
    expect test -e "$alive"
    expect test -e "$elsewhere"
    expect test -e out/.mine
}

# On a terminal Ctrl-C reaches the encoder as well, which then fails: that is no error of its own.
case_interrupt_during_the_movie() {
    small_shot
    mkdir programs
    printf '#!/bin/sh\nkill -INT $PPID\nexit 255\n' >programs/ffmpeg
    chmod +x programs/ffmpeg
    PATH=$PWD/programs:$PATH run render shot.yaml --quiet --set output.movie=true
    expect_exit 130
    expect_line stderr 'stopped; what was finished is complete, and a second run goes on from there'
    expect_clean_folder out
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
    run render shot.yaml --set output.movie=true
    expect_exit 0
    expect test -s out/shot.mp4
}

# Two runs into one folder at once are wasteful, but do no harm.
case_two_runs_at_once() {
    small_shot
    run render shot.yaml -o alone
    "$OVERFLY" render shot.yaml >/dev/null 2>other &
    render=$!
    run render shot.yaml
    expect_exit 0
    wait_for_render
    expect_exit 0
    expect_clean_folder out
    local frame
    for frame in alone/*.exr; do expect_same_frames "$frame" "out/${frame#alone/}"; done
}
