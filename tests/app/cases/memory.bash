# A shot says how much memory its render may take. How many frames go by at once is seen in nothing but that.

# What the program says is the least, on one thread.
least_memory() {
    run render shot.yaml --threads 1 --quiet "$@" --set memory_gb=0.001
    expect_exit 2
    expect_match stderr '^shot[.]yaml: memory_gb: got 0[.]001, but [0-9.]+ is the least: [0-9.]+ GB for the scene, and two frames of '
    expect test ! -e out
    least=$(sed -E 's/.*but ([0-9.]+) is the least.*/\1/' stderr)
}

case_is_said_before_the_start() {
    small_shot
    run render shot.yaml --frames 1
    expect_exit 0
    expect_match stderr '^memory: 0[.][0-9]+ GB for the scene, 0[.]0 MB a frame, 2 frames at once, of 4 GB$'
}

# Ten times the usual frame rate, so that there are many frames in a piece of the flight; film enough to matter beside
# the scene.
many_frames() { sed -i 's/count: 6/count: 40, rate: 240/; s/width: 64, height: 36/width: 256, height: 144/' shot.yaml; }

same_frames_with_little_memory() {  # same_frames_with_little_memory ARGUMENT...
    small_shot
    many_frames
    local least
    least_memory "$@"
    run render shot.yaml --threads 1 "$@" --set "memory_gb=$least" -o little
    expect_exit 0
    expect_match stderr "^memory: .*, [2-9] frames at once, of $(sed 's/0*$//' <<<"$least") GB\$"
    run render shot.yaml "$@" -o much
    expect_exit 0
    expect_match stderr '^memory: .*, [1-8][0-9] frames at once, of 4 GB$'
    expect_equal 'frames' "$(ls little/*.exr | wc -l)" 40
    local frame
    for frame in much/*.exr; do expect_same_frames "$frame" "little/${frame#much/}"; done
    # Whatever memory there was, they are the same shot's.
    run render shot.yaml "$@" --set memory_gb=2 -o little
    expect_match stderr '^little: 0 of 40 frames rendered, 40 kept, in '
}

case_drifting_lines_make_the_same_frames_of_any() { same_frames_with_little_memory; }
case_standing_lines_make_the_same_frames_of_any() { same_frames_with_little_memory --set sampling.drift_px=0; }
