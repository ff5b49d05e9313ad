# Rasters that can't become terrain: refused with the reason.

import_refused() {  # import_refused FILE PATTERN
    run import "$1" "${@:3}"
    expect_exit 2
    expect_empty stdout
    expect_equal 'lines of standard error' "$(wc -l <stderr)" 1
    expect_match stderr "$2"
    expect test ! -e terrain.yaml
}

flat_grid() {  # flat_grid VALUE: an Arc/Info text grid without a coordinate system
    printf 'ncols 3\nnrows 3\nxllcorner 450000\nyllcorner 4150000\ncellsize 75\nNODATA_value -9999\n'
    for _ in 1 2 3; do printf '%s %s %s\n' "$1" "$1" "$1"; done
}

case_missing() { import_refused nothing.tif '^nothing.tif: not found$'; }

case_a_text() {
    echo 'not a raster' >dem.tif
    import_refused dem.tif "^dem.tif: can't be opened as a raster: "
}

case_truncated() {
    small_dem whole.tif
    head -c 20000 whole.tif >dem.tif
    import_refused dem.tif "^dem.tif: can't be read to the end: " -o terrain.yaml
    # The same as the terrain of a shot.
    small_shot
    rm terrain.yaml
    small_terrain
    head -c 20000 whole.tif >dem.tif
    run render shot.yaml
    expect_exit 2
    expect_match stderr "^dem.tif: can't be read to the end: "
    expect test ! -e out
}

case_without_a_crs() {
    flat_grid 100 >dem.asc
    import_refused dem.asc '^dem.asc: .*coordinate reference system' -o terrain.yaml
    run import dem.asc --crs EPSG:32613
    expect_exit 0
    expect_match stdout '^CRS +WGS 84 / UTM zone 13N \(EPSG:32613\)$'
}

case_vectors() {
    cat >dem.geojson <<'END'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"height": 4372},
 "geometry": {"type": "Point", "coordinates": [-105.4856, 37.5775]}}]}
END
    import_refused dem.geojson '^dem.geojson: .*raster' -o terrain.yaml
}

case_no_valid_sample() {
    flat_grid -9999 >dem.asc
    import_refused dem.asc '^dem.asc: .*no valid sample' --crs EPSG:32613 -o terrain.yaml
}

case_band_that_is_not_there() {
    small_dem dem.tif
    import_refused dem.tif '^dem.tif: .*band' --band 3 -o terrain.yaml
}
