# overfly timeline: what one pixel sees, as a table, as JSON and as a drawing.

case_table() {
    small_shot
    run timeline shot.yaml --pixel 32,25
    expect_exit 0
    expect_empty stderr
    expect_match stdout '^ +triangle +from, s +to, s +depth, m +to, m +of$'
    expect_match stdout '^ +[0-9]+ +[0-9.-]+ +[0-9.]+ +[0-9.]+ +[0-9.]+ +terrain$'
    expect_match stdout '^[0-9]+ records seen of [0-9]+ passed, '
}

case_json() {
    small_shot
    run timeline shot.yaml --pixel 32,25 --frames 2-4 --json
    expect_exit 0
    expect_equal 'pixel' "$(json /pixel)" '[32,25]'
    expect_equal 'surface' "$(json /seen/0/surface)" terrain
    expect_equal 'first frame' "$(json /frames/0/frame)" 2
    expect_equal 'last frame' "$(json /frames/2/frame)" 4
    # Frames at 24 per second, open for half of that, around the frame's own time.
    expect_near 'begin' "$(json /begin_s)" "$(awk 'BEGIN { print 1 / 24 - 1 / 96 }')" 1e-6
    expect_near 'end' "$(json /end_s)" "$(awk 'BEGIN { print 3 / 24 + 1 / 96 }')" 1e-6
    # The ground fills the picture: what is seen goes on from begin to end.
    expect_near 'the first that is seen' "$(json /seen/0/begin_s)" "$(json /begin_s)" 1e-12
    expect_match stdout '"begin_depth_m": [0-9.]+'
    expect_match stdout '"end_depth_m": [0-9.]+'
    expect_equal 'passed first' "$(awk "BEGIN { print ($(json /passed/0/triangle) >= 0) }")" 1
}

case_one_piece_in_the_middle() {
    small_shot
    run timeline shot.yaml --pixel 0,0 --json
    expect_exit 0
    expect_equal 'pieces' "$(json /pieces/0/begin_s)" "$(json /begin_s)"
    expect_equal 'pieces' "$(json /pieces/0/end_s)" "$(json /end_s)"
}

case_drawing() {
    small_shot
    run timeline shot.yaml --pixel 32,25 --time 0.05-0.15 -o seen.svg
    expect_exit 0
    expect_match seen.svg '^<svg xmlns="http://www.w3.org/2000/svg" '
    expect_match seen.svg 'What pixel 32, 25 of &quot;shot&quot; sees'
    expect_match seen.svg 'Curves of intersection'
    expect_equal 'last line' "$(tail -1 seen.svg)" '</svg>'
    expect_equal 'hidden files' "$(find . -maxdepth 1 -name '.*' ! -name .)" ''
    local triangle
    triangle=$(awk 'NR == 2 { print $1 }' stdout)
    run timeline shot.yaml --pixel 32,25 --time 0.05-0.15 --triangle "$triangle" -o one.svg
    expect_exit 0
    expect_match one.svg "triangle $triangle, seen for"
    expect_equal 'curves' "$(grep -c 'class="triangle"' one.svg)" 1
}

case_same_drawing_for_any_threads() {
    small_shot
    run timeline shot.yaml --pixel 10,20 -o a.svg --threads 1
    run timeline shot.yaml --pixel 10,20 -o b.svg --threads 2
    expect cmp a.svg b.svg
}

case_sky() {
    small_shot
    run timeline shot.yaml --pixel 32,25 --set shutter.angle_deg=0 --frames 1-6 -o instants.svg
    expect_exit 0
    sed 's/pitch_deg: -1[24]/pitch_deg: 60/' flight.yaml >up.yaml
    sed 's/flight.yaml/up.yaml/' shot.yaml >sky.yaml
    run timeline sky.yaml --pixel 32,5 -o sky.svg
    expect_exit 0
    expect_match stdout '^0 records seen of 0 passed'
    expect_match sky.svg 'nothing but sky'
}

case_no_such_thing() {
    small_shot
    run timeline shot.yaml --pixel 64,0
    refused '--pixel 64,0: the picture has the pixels 0,0 to 63,35'
    run timeline shot.yaml --pixel=-1,0
    refused '--pixel -1,0: the picture has the pixels 0,0 to 63,35'
    run timeline shot.yaml --pixel 1.5,2
    refused '--pixel 1.5,2: wanted the column and the row of a pixel, two whole numbers: 480,270'
    run timeline shot.yaml --pixel 1,2 --frames 7
    refused '--frames 7: got 7, allowed frames 1 to 6'
    run timeline shot.yaml --pixel 1,2 --time 3-4
    refused '--time 3-4: the shot lasts from -0.0104 to 0.2396 s of the flight'
    run timeline shot.yaml --pixel 1,2 --time 0.2-0.1
    refused '--time 0.2-0.1: wanted a begin before the end'
    run timeline shot.yaml --pixel 1,2 --time nan-nan
    refused '--time nan-nan: wanted a begin before the end'
    run timeline shot.yaml --pixel 1,2 --time soon
    refused '--time soon: wanted a begin and an end in seconds of the flight: 2.4-2.6'
    run timeline shot.yaml --pixel 1,2 --triangle 999999999
    refused "--triangle 999999999: the pixel's line of sight doesn't pass through it in that time"
    run timeline shot.yaml --pixel 1,2 --frames 3 --set shutter.angle_deg=0
    refused "--frames 3: the frame's exposure is an instant, of which there is no time line; choose more frames or a time"
}

case_wrong_command_line() {
    small_shot
    run timeline shot.yaml
    refused 'overfly: --pixel is required (overfly timeline --help tells more)'
    run timeline shot.yaml --pixel 1,2 --frames 2 --time 0-1
    refused 'overfly: --frames excludes --time (overfly timeline --help tells more)'
    run timeline terrain.yaml --pixel 1,2
    refused 'terrain.yaml: this is a terrain document; a shot document is wanted here, configs/NAME.yaml'
    run timeline shot.yaml --pixel 1,2 -o nowhere/seen.svg
    refused 'nowhere/seen.svg: can'"'"'t be written: No such file or directory'
}
