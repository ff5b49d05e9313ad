# What a frame holds beside its pixels, read by other programs.

header() { exrheader "$1" >header; }

case_channels_and_standard_attributes() {
    small_shot
    run render shot.yaml --frames 3 --set shutter.angle_deg=90
    header out/shot.0003.exr
    local line
    for line in '    A, 16-bit floating-point, sampling 1 1' '    Z, 32-bit floating-point, sampling 1 1' \
        'compression (type compression): zip, multi-scanline blocks' \
        'displayWindow (type box2i): (0 0) - (63 35)' \
        'framesPerSecond (type rational): 24/1 (24)' \
        'shutterAngle (type float): 90' \
        'expTime (type float): 0.0104167' \
        'imageCounter (type int): 3' \
        'overfly:shot (type string): "shot.yaml"' \
        'overfly:terrain (type string): "terrain.yaml"' \
        'overfly:flight (type string): "flight.yaml"' \
        'worldToCamera (type m44f):' \
        'worldToNDC (type m44f):' \
        '    time 00:00:00:03'; do
        expect_line header "$line"
    done
    expect_match header '^Software \(type string\): "overfly [0-9.]+"$'
    expect_match header '^overfly:depth \(type string\): "planar distance along the view axis in metres'
    expect_match header '^overfly:inputs \(type string\): "[0-9a-f]{64}"$'
    # Frame 3 is a twelfth of the way: the flight is one second long and starts with frame 1.
    expect_near 'longitude' "$(sed -n 's/^longitude (type float): //p' header)" -105.528333 0.0006
    expect_near 'latitude' "$(sed -n 's/^latitude (type float): //p' header)" 37.619333 0.0006
    expect_near 'altitude' "$(sed -n 's/^altitude (type float): //p' header)" 4708.333 1.0
    # Half of 36 mm over the tangent of half of 60 degrees.
    expect_near 'focal length' "$(sed -n 's/^pinholeFocalLength (type float): //p' header)" 31.1769 0.0001
}

case_ntsc_rate() {
    small_shot
    run render shot.yaml --frames 1 --set frames.rate=29.97 --set frames.first=1
    header out/shot.0001.exr
    expect_match header '^framesPerSecond \(type rational\): 30000/1001 '
}

case_slow_motion() {
    small_shot
    run render shot.yaml --frames 1 --set frames.speed=0.25
    header out/shot.0001.exr
    expect_match header '^framesPerSecond \(type rational\): 24/1 '
    expect_match header '^captureRate \(type rational\): 96/1 '
    expect_match header '^shutterAngle \(type float\): 180$'
    expect_match header '^expTime \(type float\): 0.00520833$'
}

case_openimageio_reads_it() {
    small_shot
    run render shot.yaml --frames 2
    oiiotool --info -v out/shot.0002.exr >info
    expect_match info '64 x +36, 5 channel, half/half/half/half/float openexr'
    expect_match info 'channel list: R \(half\), G \(half\), B \(half\), A \(half\), Z \(float\)'
    expect_match info '^    [Ff]ramesPerSecond: 24/1'
    expect_match info '^    ExposureTime: 0.0208333'
    expect_match info '^    world[Tt]o[Cc]amera: '
    expect_match info '^    world[Tt]oNDC: '
}

# rendered_top COLUMN...: the row of the uppermost ground in these columns, and the first column that has it
rendered_top() {
    local column row depth_m top_row=1000 top_column=0
    for column in "$@"; do
        read -r row depth_m < <("$OVERFLY_PROBE" skyline out/shot.0001.exr "$column")
        ((row >= top_row)) || top_row=$row top_column=$column
    done
    echo "$top_row $top_column"
}

# One sharp frame through a long lens from a place near the ground: what is high stands against the sky.
render_skyline() {  # render_skyline LON LAT HEIGHT_M LOOK_AT
    cat >flight.yaml <<END
height_above: sea_level
lens: {hfov_deg: 10}
keyframes:
  - {time_s: 0, lon_deg: $1, lat_deg: $2, height_m: $3, look_at: {$4}}
END
    run render shot.yaml --set frames.count=1 --set shutter.angle_deg=0 --set image.width=160 --set image.height=90 \
        --set sampling.lines=16 --quiet
    expect_exit 0
    read -r x y depth_m < <("$OVERFLY_PROBE" summit out/shot.0001.exr terrain.yaml)
}

# Blanca Peak from the south west, 6 m to a pixel.
case_world_to_ndc_puts_blanca_peak_on_the_skyline() {
    small_shot
    local x y depth_m row seen_m
    render_skyline -105.53 37.54 4150 'lon_deg: -105.4877, lat_deg: 37.5771, height_m: 4230'
    expect_near 'the picture is of the summit' "$x" 80 10
    read -r row seen_m < <("$OVERFLY_PROBE" skyline out/shot.0001.exr "${x%.*}")
    expect_near 'row of the summit' "$row.5" "$y" 1
    expect_near 'depth of the summit' "$seen_m" "$depth_m" 75  # the next vertex may hide the foot of the pixel
    expect_equal 'nothing near it is higher' "$(rendered_top $(seq $((${x%.*} - 8)) $((${x%.*} + 8))) | cut -d' ' -f1)" "$row"
}

# A needle on a plain, to know left from right: its tip has one pixel of the picture to itself.
case_world_to_ndc_puts_a_needle_where_it_is_seen() {
    awk 'BEGIN { print "ncols 61\nnrows 61\nxllcorner 450000\nyllcorner 4150000\ncellsize 75"
        for (r = 0; r < 61; ++r) for (c = 0; c < 61; ++c) printf "%d%s", r == 20 && c == 37 ? 3100 : 3000, c < 60 ? " " : "\n" }' >needle.asc
    printf 'dem: needle.asc\ncrs: EPSG:32613\nvertical_datum: egm96\n' >terrain.yaml
    small_shot
    local x y depth_m row column
    render_skyline -105.5631 37.4975 3040 'lon_deg: -105.538, lat_deg: 37.520, height_m: 3060'
    read -r row column < <(rendered_top $(seq $((${x%.*} - 12)) $((${x%.*} + 12))))
    expect_near 'row of the tip' "$row.5" "$y" 1
    expect_near 'column of the tip' "$column.5" "$x" 1
}

# A level square at the highest sample, once black and once white: what differs between the two is what the square covers,
# whatever lies behind it. Seen from straight above and askew, the middle of that is where the summit is rendered: no
# perspective moves it, and sides across the pixels' rows leave nothing of their grid. Its place comes from GDAL's own
# programs, the summit's from worldToNDC and the mesh.
marked_summit() {  # marked_summit OPTION...: into x y (projected) and seen_x seen_y (rendered), in pixels
    small_shot
    local east north height_m lon lat square='[[30, 30, 0], [-30, 30, 0], [-30, -30, 0], [30, -30, 0]]'
    read -r east north height_m < <(gdal_translate -q -of XYZ dem.tif /vsistdout/ | sort -gk3 | tail -1)
    read -r lon lat _ < <(gdaltransform -s_srs EPSG:32613 -t_srs EPSG:4326 <<<"$east $north")
    cat >flight.yaml <<END
height_above: sea_level
lens: {hfov_deg: 20}
keyframes:
  - {time_s: 0, lon_deg: -105.4895, lat_deg: 37.5760, height_m: 7000, heading_deg: 20, pitch_deg: -90}
  - {time_s: 1, lon_deg: -105.4880, lat_deg: 37.5764, height_m: 7050, heading_deg: 25, pitch_deg: -90}
END
    cat >>shot.yaml <<END
bodies:
  - {name: marker, shadow: false, polygons: [$square], place: {lon_deg: $lon, lat_deg: $lat, height_m: $height_m, height_above: sea_level}}
END
    set -- --frames 3 --set image.width=320 --set image.height=180 --set sampling.lines=64 --quiet "$@"
    run render shot.yaml "$@" -o white --set bodies.0.colour=[1,1,1]
    expect_exit 0
    run render shot.yaml "$@" -o black --set bodies.0.colour=[0,0,0]
    expect_exit 0
    read -r x y _ < <("$OVERFLY_PROBE" summit white/shot.0003.exr terrain.yaml)
    read -r seen_x seen_y < <("$OVERFLY_PROBE" centroid white/shot.0003.exr black/shot.0003.exr G)
}

case_world_to_ndc_is_exact_to_a_hundredth_of_a_pixel() {
    local x y seen_x seen_y
    marked_summit --set shutter.angle_deg=0
    expect_near 'x of the summit' "$seen_x" "$x" 0.01
    expect_near 'y of the summit' "$seen_y" "$y" 0.01
}

# The header's camera is that of the middle of the exposure, whatever its phase: so is the middle of the blur.
case_world_to_ndc_is_that_of_the_middle_of_the_exposure() {
    local x y seen_x seen_y
    marked_summit --set shutter.angle_deg=360 --set shutter.phase=start
    expect_near 'x of the summit' "$seen_x" "$x" 0.01
    expect_near 'y of the summit' "$seen_y" "$y" 0.01
}

case_date_rate_and_documents() {
    small_shot
    run render shot.yaml --frames 3 --set frames.date=2026-06-21T23:59:59-06:00 --set frames.start_s=1
    expect_exit 0
    header out/shot.0003.exr
    local line document
    for line in 'capDate (type string): "2026:06:22 00:00:00"' 'utcOffset (type float): 21600' \
        'overfly:date (type string): "2026-06-22T00:00:00.083333-06:00"' 'captureRate (type rational): 24/1 (24)' \
        'sensorCenterOffset (type v2f): (0 0)' 'pixelAspectRatio (type float): 1' \
        'screenWindowCenter (type v2f): (0 0)' 'worldToNDC (type m44f):' 'overfly:worldToNDC (type m44d)'; do
        expect_line header "$line"
    done
    expect_match header '^screenWindowWidth \(type float\): 1[.]1547'
    expect_match header '^chromaticities \(type chromaticities\):$'
    for document in shot terrain flight; do
        expect_line header "overfly:${document}Sha256 (type string): \"$(sha256sum <$document.yaml | cut -d' ' -f1)\""
    done
    oiiotool --info -v out/shot.0003.exr >info
    expect_match info '^    DateTime: "2026:06:22 00:00:00"'
    expect_match info '^    captureRate: 24/1'
    # A date changes headers, so frames with another one are of another version.
    run render shot.yaml --frames 3 --set frames.date=2026-06-21T23:59:58-06:00 --set frames.start_s=1
    expect_line stderr '1 frames are of an earlier version of the shot and are rendered again'
}
