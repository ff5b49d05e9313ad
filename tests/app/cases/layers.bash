# Layers of frames, in their files or in files of their own.

layered() {  # layered [OPTION]...: a shot of six frames with three layers, rendered
    small_shot
    sed -i 's/lines: 1/lines: 1, tracer: discrete, samples: 4/' shot.yaml
    printf 'layers: [N, cost, id]\n' >>shot.yaml
    run render shot.yaml --set output.layer_files=true "$@"
    expect_exit 0
}

verify_finds() {  # verify_finds LINE...
    run verify out
    expect_exit 2
    expect_equal 'bad frames' "$(cat stderr)" "$(printf '%s\n' "$@")"
}

case_a_file_for_each() {
    layered
    expect_equal 'files' "$(cd out && echo *)" "$(echo manifest.json shot.{0001,0002,0003,0004,0005,0006,N.0001,N.0002,N.0003,N.0004,N.0005,N.0006,cost.0001,cost.0002,cost.0003,cost.0004,cost.0005,cost.0006,id.0001,id.0002,id.0003,id.0004,id.0005,id.0006}.exr)"
    expect_equal 'listed' "$("$OVERFLY_PROBE" json /sequences/shot/layer_files <out/manifest.json)" '["N","id","cost"]'
    run verify out
    expect_exit 0
    expect_equal 'says' "$(cat stdout)" 'shot: 6 of 6 frames are sound and as the manifest lists them'
    # The same frames as in one file each.
    run render shot.yaml --frames 4 -o one
    expect_equal 'files' "$(cd one && echo *)" 'manifest.json shot.0004.exr'
    expect_same_frames one/shot.0004.exr out/shot.0004.exr
    expect_equal 'hash' "$("$OVERFLY_PROBE" json /sequences/shot/frames/0/pixels_sha256 <one/manifest.json)" \
        "$("$OVERFLY_PROBE" json /sequences/shot/frames/3/pixels_sha256 <out/manifest.json)"
}

case_a_frame_is_as_good_as_its_layers() {
    layered
    cp -r out first
    rm out/shot.N.0002.exr
    truncate -s -50 out/shot.cost.0003.exr
    cp out/shot.id.0001.exr out/shot.id.0004.exr
    "$OVERFLY_PROBE" change out/shot.N.0005.exr N.X 0.5
    run verify out --json
    local i faults=
    for i in 0 1 2 3; do faults+="$(json /sequences/0/bad/$i/number) $(json /sequences/0/bad/$i/fault), "; done
    expect_equal 'faults' "$faults" '2 layer_missing, 3 truncated, 4 misplaced, 5 pixels, '
    verify_finds 'out/shot.0002.exr: shot.N.0002.exr: missing' \
        "out/shot.0003.exr: shot.cost.0003.exr: can't be read as a frame: it is cut off" \
        'out/shot.0004.exr: shot.id.0004.exr: it is frame 1 by its header' \
        'out/shot.0005.exr: its pixels are not those that the manifest lists'
    run render shot.yaml --set output.layer_files=true
    expect_match stderr '^out: 3 of 6 frames rendered, 3 kept, in '
    run render shot.yaml --set output.layer_files=true --repair --json
    expect_equal 'repaired' "$(json /frames/rendered)" 1
    run verify out
    expect_exit 0
    local file
    for file in first/shot.0*.exr; do expect_same_frames "$file" "out/${file#first/}"; done
}

case_a_layer_that_is_no_longer_asked_for() {
    layered
    run render shot.yaml --set output.layer_files=true --set layers=N
    expect_match stderr '6 frames are of an earlier version of the shot'
    run verify out
    expect_exit 0
    expect_line stderr 'note: out/shot.id.0003.exr: the sequence has no such frame'
    expect_equal 'notes' "$(wc -l <stderr)" 12
}

case_without_a_manifest() {
    layered
    rm out/manifest.json out/shot.id.0005.exr
    run verify out
    expect_exit 2
    expect_line stderr 'out/shot.0005.exr: shot.id.0005.exr: missing'
    expect_line stdout 'shot: 5 of 6 frames are sound by themselves'
    expect_equal 'sequences' "$(wc -l <stdout)" 1
}

# Wherever it is killed: a frame that is there has all its layers, and no layer is half written.
case_killed_while_writing() {
    layered --frames 1-3
    mv out whole
    local delay file
    for delay in 0 0.03; do
        rm -rf out
        "$OVERFLY" render shot.yaml --set output.layer_files=true --frames 1-3 >stdout 2>stderr &
        local render=$!
        wait_until 100 test -e out/shot.N.0001.exr
        sleep "$delay"
        kill -KILL "$render" 2>/dev/null || true
        wait "$render" || true
        for file in out/shot.0*.exr; do
            [[ ! -e $file ]] || expect "$OVERFLY_PROBE" complete "$file"
        done
        for file in out/shot.[Nci]*.exr; do
            run info "$file"
            expect_exit 0
        done
    done
    run render shot.yaml --set output.layer_files=true --frames 1-3
    expect_exit 0
    run verify out --frames 1-3
    expect_exit 0
    expect_equal 'hidden files' "$(find out -name '.*' ! -name '.' ! -name '..')" ''
    for file in whole/shot.0*.exr; do expect_same_frames "$file" "out/${file#whole/}"; done
}
