# Lines of the kinetic tracer asked again by rays, for whoever doubts them.

# expect_only_edges_differ: of the JSON in stdout; leaves the three counts in checked, differed and by_edge
expect_only_edges_differ() {
    checked=$(json /tracer/checked) differed=$(json /tracer/differed) by_edge=$(json /tracer/differed_by_edge)
    expect_equal 'differing away from edges' "$((differed - by_edge))" 0
    expect test "$differed" -le "$((checked / 1000))"
}

case_every_line_is_asked_again() {
    local checked differed by_edge
    small_shot
    run render shot.yaml --check-every 1 --json
    expect_exit 0
    expect_equal 'frames rendered' "$(json /frames/rendered)" 6
    # At least each pixel's line, once in each piece of the motion.
    expect test "$(json /motion/pieces)" -ge 1
    expect test "$(json /tracer/checked)" -ge "$((64 * 36))"
    expect_only_edges_differ
    expect_match stderr "^checked: $differed of $checked answers differ from a discrete ray's, [0-9.]+ %; $by_edge of them at an edge\$"
}

case_people_are_told_without_json() {
    small_shot
    run render shot.yaml --check-every 1
    expect_exit 0
    expect_empty stdout
    expect_match stderr "^checked: [0-9]+ of [1-9][0-9]* answers differ from a discrete ray's, [0-9.]+ %; [0-9]+ of them at an edge\$"
}

case_fewer_lines_where_fewer_are_asked_for() {
    local checked differed by_edge all
    small_shot
    run render shot.yaml --check-every 1 --json
    all=$(json /tracer/checked)
    rm -r out
    run render shot.yaml --check-every 10 --json
    expect_exit 0
    expect_only_edges_differ
    expect test "$checked" -gt "$((all / 20))"
    expect test "$checked" -lt "$((all / 5))"
}

case_none_unless_asked_for() {
    small_shot
    run render shot.yaml --json
    expect_exit 0
    expect_equal 'checked' "$(json /tracer/checked)" 0
    expect_no_match stderr '^checked:'
}

case_pixels_are_the_same() {
    local frame
    small_shot
    run render shot.yaml
    mv out unchecked
    run render shot.yaml --check-every 1
    expect_exit 0
    for frame in unchecked/*.exr; do expect_same_frames "$frame" "out/${frame#unchecked/}"; done
}
