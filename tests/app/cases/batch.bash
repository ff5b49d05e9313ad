# overfly batch: one shot after another, whatever becomes of each.

case_one_bad_among_three() {
    small_shot a
    small_shot b
    small_shot c
    sed -i 's/width: 64/width: wide/' b.yaml
    run batch a.yaml b.yaml c.yaml
    expect_exit 2
    expect_equal 'frames of a' "$(ls out/a.*.exr | wc -l)" 6
    expect_equal 'frames of c' "$(ls out/c.*.exr | wc -l)" 6
    expect test ! -e out/b.0001.exr
    sed -n '/^batch of/,$p' stderr >end
    expect_line end 'batch of 3 shots:'
    expect_match end '^  done    a.yaml: 6 frames rendered, 0 kept, '
    expect_line end '  FAILED  b.yaml'
    expect_match end '^          b.yaml:4:16: image.width: got .wide., allowed '
    expect_match end '^  done    c.yaml: 6 frames rendered, 0 kept, '
}

case_all_good() {
    small_shot a
    small_shot b
    run batch a.yaml b.yaml --json
    expect_exit 0
    expect_equal 'shots' "$(json /shots/0/shot) $(json /shots/1/shot)" 'a.yaml b.yaml'
    expect_equal 'done' "$(json /shots/1/done)" true
    expect_equal 'rendered' "$(json /shots/1/result/frames/rendered)" 6
}

case_batch_documents_and_shots_mixed() {
    small_shot a
    small_shot b
    mkdir lists
    printf 'shots:\n  - ../b.yaml\n' >lists/night.yaml
    run batch a.yaml lists/night.yaml nothing.yaml --quiet --set frames.count=2
    expect_exit 2
    expect_equal 'frames' "$(ls out)" "$(printf '%s\n' a.0001.exr a.0002.exr b.0001.exr b.0002.exr manifest.json)"
    refused '  FAILED  nothing.yaml' '          nothing.yaml: no such file'
}

# Hours of frames would be written over one by one.
case_two_shots_with_the_same_frames() {
    small_shot a
    small_shot b
    sed -i 's/name: b/name: a/' b.yaml
    run batch a.yaml b.yaml a.yaml
    expect_exit 2
    expect_line stderr "          b.yaml: writes the same frames as a.yaml, out/a.*.exr; give it another output.folder or output.name"
    expect_equal 'done' "$(grep -c '^  done    a.yaml: ' stderr)" 2
}

case_failure_while_rendering() {
    small_shot a
    small_shot b
    mkdir -p out/a.0002.exr/inside
    run batch a.yaml b.yaml
    expect_exit 2
    expect_line stderr "          out/a.0002.exr: can't be written: Is a directory"
    expect_equal 'frames of b' "$(ls out/b.*.exr | wc -l)" 6
}
