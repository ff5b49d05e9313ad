# What overfly info tells of a frame.

case_of_a_frame() {
    small_shot
    run render shot.yaml --frames 3 --set frames.date=2026-06-21T09:30:00-06:00 --set shutter.angle_deg=90
    run info out/shot.0003.exr
    expect_exit 0
    expect_empty stderr
    local line
    for line in 'size              64 x 36' 'frame             3' 'time              0.083333 s of the flight' \
        'date              2026-06-21T09:30:00.083333-06:00' 'rate              24 frames per second' \
        'time code         00:00:00:03' 'exposure          0.0104167 s, 90 degrees' \
        'lens              31.18 mm before a sensor 36 mm wide, 60.000 degrees across'; do
        expect_line stdout "$line"
    done
    expect_match stdout '^place +lon -105[.]528[0-9]+ lat 37[.]619[0-9]+, [0-9.]+ m above the ellipsoid, 470[0-9.]+ m above sea level$'
    expect_match stdout '^attitude +heading 14[0-9.]+, pitch -12[0-9.]+, roll 0[.]000 degrees$'
    expect_match stdout '^shot +shot.yaml  SHA-256 [0-9a-f]{64}$'
    expect_match stdout '^R +half +zip +[0-9.e-]+ +[0-9.]+ +[0-9.]+ +0 +0$'
    expect_match stdout '^Z +float +zip +[0-9.]+ +[0-9.e+]+ +1e[+]10 +0 +0$'
    run info out/shot.0003.exr --json
    expect_near 'longitude' "$(json /camera/place/lon_deg)" -105.528333 0.0006
    expect_near 'heading' "$(json /camera/attitude/heading_deg)" 140.83 0.5
    expect_near 'pitch' "$(json /camera/attitude/pitch_deg)" -12.17 0.2
    expect_near 'roll' "$(json /camera/attitude/roll_deg)" 0 0.000001
    expect_equal 'rate' "$(json /rate)" '[24,1]'
    expect_equal 'channel' "$(json /channels/4/name) $(json /channels/4/type) $(json /channels/4/nan)" 'Z float 0'
    expect_equal 'hash' "$(json /documents/flight/sha256)" "$(sha256sum <flight.yaml | cut -d' ' -f1)"
}

case_counts_what_is_no_number() {
    small_shot
    run render shot.yaml --frames 1
    "$OVERFLY_PROBE" change out/shot.0001.exr G nan
    run info out/shot.0001.exr
    expect_match stdout '^G +half +zip +0 +0 +0 +2304 +0$'
}

case_of_another_programs_picture() {
    oiiotool --create 8x4 3 --fill:color=0.25,0.5,1 8x4 -d half -o other.exr
    run info other.exr
    expect_exit 0
    expect_line stdout 'size              8 x 4'
    expect_match stdout '^R +half +[a-z0-9]+ +0[.]25 +0[.]25 +0[.]25 +0 +0$'
    expect_no_match stdout '^(place|attitude|frame|shot) '
}

case_of_what_is_no_frame() {
    small_shot
    run info shot.yaml
    refused 'shot.yaml: a shot document; overfly path tells of its flight'
    run info terrain.yaml
    refused 'terrain.yaml: a terrain document; overfly import tells what it holds'
    run info nothing.exr
    refused 'nothing.exr: no such frame'
    run info dem.tif
    expect_exit 2
    expect_match stderr "^dem.tif: can't be read as a frame: "
}

case_of_a_frame_with_layers() {
    small_shot
    printf 'layers: [N, id, cryptomatte, lon]\n' >>shot.yaml
    run render shot.yaml --frames 3
    run info out/shot.0003.exr
    expect_exit 0
    expect_match stdout '^N: normal in the scene'
    expect_match stdout '^N[.]X +half +zip +-0[.][0-9]+ +-?[0-9.e-]+ +[0-9.]+ +0 +0$'
    expect_match stdout '^lon +float +zip +-105[.]5'
    expect_match stdout '^id +uint +zip +0 +[0-9]{9,10} +0 +0$'
    expect_match stdout '^terrain +0[.][0-9]{6}$'
    run info out/shot.0003.exr --json
    expect_equal 'object' "$(json /objects/0/name)" terrain
    expect_equal 'layer files' "$(json /layer_files)" '[]'
    local share
    share=$(json /objects/0/coverage)
    run render shot.yaml --frames 3 --set output.layer_files=true -o files
    run info files/shot.0003.exr --json
    expect_equal 'layer files' "$(json /layer_files)" '["N","lon","id","cryptomatte"]'
    expect_equal 'channels' "$(json /channels/4/name)" Z
    run info files/shot.cryptomatte.0003.exr --json
    expect_equal 'share' "$(json /objects/0/coverage)" "$share"
    expect_equal 'layer' "$(json /channels/0/layer)" cryptomatte
}
