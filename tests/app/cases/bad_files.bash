# What the file system may refuse: a clear line, exit code 2, nothing half-written.

case_output_is_a_file() {
    small_shot
    echo kept >out
    run render shot.yaml
    refused 'out: output.folder: can'\''t be made: Not a directory'
    expect_line out kept
}

# Under a file there is no folder even for root, whom permissions don't stop.
case_output_under_a_file() {
    small_shot
    echo kept >out
    run render shot.yaml -o out/frames
    refused 'out/frames: output.folder: can'\''t be made: Not a directory'
}

case_a_folder_has_the_name_of_a_frame() {
    small_shot
    mkdir -p out/shot.0003.exr/inside
    run render shot.yaml
    expect_exit 2
    expect_line stderr "out/shot.0003.exr: can't be written: Is a directory"
    expect test -d out/shot.0003.exr/inside
    expect_equal 'hidden files' "$(find out -name '.*')" ''
}

# A limit on the size of files stands for a full disk: the same errors come from the same calls, for root as well.
render_with_full_disk() {  # render_with_full_disk BLOCKS ARGUMENT...
    exit_code=0
    (ulimit -f "$1" && shift && exec "$OVERFLY" "$@") >stdout 2>stderr || exit_code=$?
}

case_disk_full_while_writing_a_frame() {
    small_shot
    render_with_full_disk 4 render shot.yaml --quiet
    # Frames are written side by side, and any of them may be the first to fail.
    expect_match stderr "^out/shot[.]000[1-4][.]exr: can't be written: File too large$"
    refused "$(head -1 stderr)"
    expect_equal 'files' "$(ls -A out)" ''
    expect_equal 'files in the cache' "$(find cache -type f)" ''
    run render shot.yaml --quiet
    expect_exit 0
    expect_clean_folder out
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
}

case_manifest_cannot_be_written() {
    small_shot
    mkdir -p out/manifest.json/inside
    run render shot.yaml --quiet
    refused "out/manifest.json: can't be written: Is a directory"
    expect_clean_folder out
    rm -r out/manifest.json
    run render shot.yaml
    expect_exit 0
    run verify out
    expect_exit 0
}

case_disk_full_while_writing_the_contact_sheet() {
    small_shot
    render_with_full_disk 24 render shot.yaml --quiet --set output.contact_sheet=true
    refused "out/shot.contact.png: can't be written: File too large"
    expect_clean_folder out
    expect_equal 'frames' "$(ls out)" "$(printf 'manifest.json\n'; printf 'shot.%04d.exr\n' 1 2 3 4 5 6)"
}

case_disk_full_while_writing_the_movie() {
    small_shot
    run render shot.yaml --quiet
    render_with_full_disk 1 render shot.yaml --quiet --set output.movie=true
    expect_exit 2
    expect_match stderr '^out/shot.mp4: ffmpeg failed: '
    expect_clean_folder out
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
}

case_terrain_document_cannot_be_written() {
    small_dem dem.tif
    echo kept >folder
    run import dem.tif -o folder/terrain.yaml
    refused "folder/terrain.yaml: can't be written"
}

case_no_place_for_the_cache() {
    small_shot
    echo kept >no_folder
    XDG_CACHE_HOME=$PWD/no_folder run render shot.yaml --quiet
    expect_exit 0
    expect_empty stderr
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
}

case_standard_output_is_full() {
    small_dem dem.tif
    exit_code=0
    : >stdout
    "$OVERFLY" import dem.tif --json >/dev/full 2>stderr || exit_code=$?
    refused "standard output: can't be written: No space left on device"
}

# A log on a full disk is no reason to lose a render.
case_standard_error_is_full() {
    small_shot
    exit_code=0
    "$OVERFLY" render shot.yaml >stdout 2>/dev/full || exit_code=$?
    : >stderr
    expect_exit 0
    expect_clean_folder out
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
    "$OVERFLY" render nothing.yaml 2>/dev/full || exit_code=$?
    expect_exit 2
}

case_missing_ffmpeg() {
    small_shot
    mkdir empty
    PATH=$PWD/empty run render shot.yaml --quiet --set output.movie=true
    refused 'out/shot.mp4: needs the program ffmpeg, which is not installed (Debian: apt-get install ffmpeg)'
    expect_clean_folder out
    expect_equal 'frames' "$(ls out/*.exr | wc -l)" 6
    run render shot.yaml --set output.movie=true
    expect_exit 0
    expect_match stderr '^out: 0 of 6 frames rendered, 6 kept, in '
    expect test -s out/shot.mp4
}
