# What the program says, and where.

case_version() {
    run --version
    expect_exit 0
    expect_empty stderr
    expect_match <(head -1 stdout) '^overfly [0-9]+[.][0-9]+[.][0-9]+$'
    local library
    for library in oneTBB GeographicLib GEOS Embree Highway GDAL PROJ OpenEXR OpenImageIO OpenColorIO Assimp yaml-cpp; do
        expect_match stdout "^$library [0-9]+[.]"
    done
}

case_help() {
    run --help
    expect_exit 0
    local verb
    for verb in import path render batch bench timeline verify info; do expect_match stdout "^  $verb  +[a-z]"; done
    for verb in import path render batch bench 'bench flight' 'bench hybrid' 'bench paper' timeline verify info; do
        # shellcheck disable=SC2086
        run $verb --help
        expect_exit 0
        expect_empty stderr
        expect_match stdout "^Usage: overfly $verb "
    done
}

case_no_verb() {
    run
    refused 'overfly: a verb is missing; known: import, path, render, batch, bench, timeline, verify, info (overfly --help tells more)'
}

case_unknown_verb() {
    run rendr shot.yaml
    refused "overfly: unknown verb 'rendr'; did you mean 'render'? known: import, path, render, batch, bench, timeline, verify, info (overfly --help tells more)"
}

case_unknown_options() {
    run --nonsense
    refused "overfly: unknown option '--nonsense'; a verb comes first: import, path, render, batch, bench, timeline, verify, info (overfly --help tells more)"
    run render shot.yaml --nonsense
    refused 'overfly: The following argument was not expected: --nonsense (overfly render --help tells more)'
    run render
    refused 'overfly: shot is required (overfly render --help tells more)'
    run render shot.yaml --threads 0
    refused 'overfly: --threads: Value 0 not in range 1 to 4096 (overfly render --help tells more)'
    run render shot.yaml --threads two
    expect_exit 2
    expect_equal 'lines' "$(wc -l <stderr)" 1
}

case_json_alone_on_standard_output() {
    small_shot
    run render shot.yaml --json
    expect_exit 0
    expect_equal 'frames' "$(json /frames)" '{"in_shot":6,"kept":0,"rendered":6,"wanted":6}'
    expect_equal 'folder' "$(json /folder)" out
    run render shot.yaml --json --frames 9
    expect_exit 2
    expect_empty stdout
    run bench flight shot.yaml --pairs 1000 --json
    expect_exit 0
    expect_equal 'pairs' "$(json /agreement/pairs)" 1000
    expect_equal 'lines that see something else by inflated boxes' "$(json /volumes/differing_rays)" 0
    expect_equal 'boxes that last for one piece' "$(json /volumes/swollen/0/pieces)" 1
    local of count
    for of in inflated swept swept_in_parts; do
        for count in bv_tests bv_hits poly_tests poly_hits; do
            expect_equal "$of $count" "$(awk "BEGIN { print ($(json /volumes/$of/$count) > 0) }")" 1
        done
    done
}

case_quiet() {
    small_shot
    run render shot.yaml --quiet
    expect_exit 0
    expect_empty stdout
    expect_empty stderr
    run path shot.yaml --quiet
    expect_exit 0
    expect_empty stdout
    run import dem.tif --quiet -o new.yaml
    expect_exit 0
    expect_empty stdout
    expect_empty stderr
}

case_render_says_where_things_are() {
    small_shot
    run render shot.yaml --set output.contact_sheet=true --set output.movie=true
    expect_exit 0
    expect_empty stdout
    expect_match stderr '^out: 6 of 6 frames rendered, 0 kept, in [0-9.]+ s$'
    expect_line stderr 'contact sheet: out/shot.contact.png'
    expect_line stderr 'preview movie: out/shot.mp4'
}

case_render_tells_of_frames_outside_the_flight() {
    small_shot
    run render shot.yaml --frames 2
    expect_no_match stderr '^note'
    run render shot.yaml --set frames.count=30 --frames 24-27
    expect_exit 0
    expect_line stderr 'note: in 2 of 4 frames, the first is 26, the flight of 1.000 s has not begun or is over, and the camera goes straight on'
}

# Names with blanks and letters beyond ASCII, and documents that are not in the working directory.
case_any_names_and_folders() {
    mkdir -p 'Blanca Péak/documents'
    cd 'Blanca Péak/documents'
    small_shot
    mv shot.yaml "o'ne shot.yaml"
    cd ../..
    run render "Blanca Péak/documents/o'ne shot.yaml" --set output.movie=true --set output.contact_sheet=true --json
    expect_exit 0
    expect test -s 'Blanca Péak/documents/out/shot.0006.exr'
    expect test -s 'Blanca Péak/documents/out/shot.mp4'
    expect_equal 'folder' "$(json /folder)" 'Blanca Péak/documents/out'
    # What is typed is relative to where it is typed.
    run render "Blanca Péak/documents/o'ne shot.yaml" --frames 1 -o 'new öut'
    expect_exit 0
    expect test -s 'new öut/shot.0001.exr'
}

# Plain lines now and then where standard error is no terminal, so that a log stays readable.
case_progress_in_plain_lines() {
    small_shot
    sed -i 's/count: 6/rate: 48/; s/lines: 1/lines: 32/' shot.yaml
    "$OVERFLY" render shot.yaml >stdout 2>stderr &
    local render=$!
    wait_until 200 grep -q 'frames/s' stderr
    kill -TERM "$render"
    wait "$render" || exit_code=$?
    expect_match stderr '^rendering: frame [0-9]+ of 48, [0-9.]+ frames/s, [0-9:]+ (s|min) left$'
    expect_no_match stderr $'[\r\033]'
}

# One line that is written over on a terminal, and gone at the end.
case_progress_on_a_terminal() {
    small_shot
    script -qec "'$OVERFLY' render shot.yaml --set sampling.lines=16" /dev/null >screen </dev/null
    expect_match screen $'\r\033\\[Krendering: frame [0-9]+ of 6, [0-9.]+ frames/s'
    expect_match screen $'\r\033\\[Kout: 6 of 6 frames rendered, 0 kept, in '
}
