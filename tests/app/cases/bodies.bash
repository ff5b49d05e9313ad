# Bodies in a shot, as far as documents and files go: what is refused, what is said, what is drawn anew when one of them
# changes.

# shot_with_body LINE...: the small shot, and a body called kite with these keys
shot_with_body() {
    small_shot
    printf 'bodies:\n  - name: kite\n' >>shot.yaml
    printf '    %s\n' "$@" >>shot.yaml
}

triangle='polygons: [[[0, 0, 0], [40, 0, 0], [0, 40, 10]]]'
in_sight='place: {lon_deg: -105.5285, lat_deg: 37.6185, height_m: 4630}'

nothing_left_behind() { expect_equal 'folders' "$(find . -mindepth 1 -type d ! -path './cache*')" ''; }

triangle_file() { printf 'v 0 0 0\nv %s 0 0\nv 0 40 10\nf 1 2 3\n' "$1" >kite.obj; }

case_mesh_that_is_broken() {
    shot_with_body 'mesh: kite.obj' "$in_sight"
    : >kite.obj
    run render shot.yaml
    expect_match stderr "^kite.obj: can't be used as a mesh: ."
    refused "$(head -1 stderr)"
    printf 'v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n' >kite.obj
    run render shot.yaml
    refused "kite.obj: can't be used as a mesh: 1 of its 3 positions are not finite or farther than 10,000 km from the middle"
    nothing_left_behind
}

case_mirror_that_is_not_flat() {
    shot_with_body 'mesh: kite.obj' "$in_sight" 'mirror: 0.5'
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n' >kite.obj
    run render shot.yaml
    expect_match stderr "^shot.yaml:8:5: body 'kite': .* [0-9.]+ m off "
    refused "$(head -1 stderr)"
    nothing_left_behind
}

case_mesh_that_holds_more_than_faces() {
    shot_with_body 'mesh: kite.obj' "$in_sight"
    triangle_file 40
    printf 'f 1 2 2\nf 1 1 1\nl 1 2\n' >>kite.obj
    run render shot.yaml --frames 1-2
    expect_exit 0
    local note='note: kite.obj: not drawn: faces without area or that cross themselves: 2, points and lines: 1'
    expect_line stderr "$note"
    expect_equal 'notes' "$(grep -c '^note' stderr)" 1
    # Nothing to draw, nothing to say.
    run render shot.yaml --frames 1-2
    expect_no_match stderr '^note'
    triangle_file 40
    run render shot.yaml --frames 1-2
    expect_match stderr '^out: 2 of 2 frames rendered'
    expect_no_match stderr '^note'
}

case_height_above_ground_that_is_not_there() {
    shot_with_body "$triangle" 'place: {lon_deg: 7, lat_deg: 46, height_m: 10, height_above: ground}'
    run render shot.yaml
    refused "shot.yaml:8:5: body 'kite': lon 7.000000, lat 46.000000: height is counted from the ground, but there is no\
 terrain; move the body onto the terrain or count from sea level or the ellipsoid"
    nothing_left_behind
}

case_frames_are_outdated_when_a_mesh_or_a_flight_changes() {
    small_shot
    cp flight.yaml other.yaml
    printf 'bodies:\n  - {name: kite, mesh: kite.obj, flight: other.yaml, delay_s: -0.1}\n' >>shot.yaml
    triangle_file 40
    run render shot.yaml --frames 1-2
    expect_exit 0
    run render shot.yaml --frames 1-2
    expect_match stderr '^out: 0 of 2 frames rendered, 2 kept, in '
    triangle_file 41
    run render shot.yaml --frames 1-2
    expect_match stderr '^out: 2 of 2 frames rendered, 0 kept, in '
    sed -i 's/height_m: 4800/height_m: 4801/' other.yaml
    run render shot.yaml --frames 1-2
    expect_match stderr '^out: 2 of 2 frames rendered, 0 kept, in '
}

case_a_body_is_seen() {
    small_shot
    run render shot.yaml --frames 1-1
    expect_exit 0
    mv out without
    shot_with_body "$triangle" "$in_sight"
    run render shot.yaml --frames 1-1
    expect_exit 0
    "$OVERFLY_PROBE" same out/shot.0001.exr without/shot.0001.exr && fail 'the same frame with and without the body'
    run render shot.yaml --frames 1-1 --set bodies=[]
    expect_same_frames out/shot.0001.exr without/shot.0001.exr
}
