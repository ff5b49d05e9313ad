# overfly import: what it says of good elevation data, and the document that it writes.

# The report of a raster of the same ground in other coordinates, as JSON.
import_warped() {  # import_warped CRS [OPTION of gdalwarp]...
    small_dem utm.tif
    gdalwarp -q -overwrite -r bilinear -dstnodata -32768 -t_srs "$@" utm.tif dem.tif
    run import dem.tif --json
    expect_exit 0
    expect_near "triangles" "$(json /triangles)" 38642 6000
    expect_near 'lowest' "$(json /height_m/min)" 2600 200
    expect_near 'highest' "$(json /height_m/max)" 4255 6
    expect_near 'west' "$(json /extent_deg/west)" -105.546 0.005
    expect_near 'north' "$(json /extent_deg/north)" 37.622 0.005
}

case_utm() {
    small_dem dem.tif
    run import dem.tif --json
    expect_exit 0
    expect_empty stderr
    expect_equal 'files' "$(json /files)" '["dem.tif"]'
    expect_equal 'format' "$(json /format)" GTiff
    expect_equal 'CRS' "$(json /crs/authority)" EPSG:32613
    expect_equal 'samples' "$(json /samples)" '{"columns":140,"rows":140,"valid":19600}'
    expect_equal 'no data' "$(json /no_data/share)" 0.0
    expect_equal 'vertical unit' "$(json /vertical_unit/name)" m
    expect_equal 'vertical datum is only assumed' "$(json /vertical_datum/known)" assumed
    expect_equal 'highest' "$(json /height_m/max)" 4260.0
    expect_equal 'triangles' "$(json /triangles)" $((139 * 139 * 2))
    expect_equal 'vertices' "$(json /vertices)" 19600
    # The scene's east is that of its middle, a degree or so from the grid's.
    expect_near 'east' "$(json /bounds_m/east/1)" $((139 * 75 / 2)) 80
    expect_near 'north' "$(json /bounds_m/north/1)" $((139 * 75 / 2)) 80
    expect_match stdout '"seconds": [0-9.e-]+'
    expect_match stdout '"peak_memory_mb": [0-9.]+'
    expect_equal 'from the cache' "$(json /from_cache)" false
}

case_geographic() { import_warped EPSG:4326; }
case_web_mercator() { import_warped EPSG:3857; }
case_us_survey_feet_plane() { import_warped EPSG:2233; }
case_another_ellipsoid() { import_warped EPSG:26713; }

case_heights_in_feet() {
    small_dem dem.tif -ot Float32 -scale 0 1000 0 3280.8399
    run import dem.tif --vertical-unit ft --json
    expect_exit 0
    expect_near 'highest' "$(json /height_m/max)" 4260 0.01
    expect_equal 'unit' "$(json /vertical_unit/name)" ft
    expect_equal 'known' "$(json /vertical_unit/known)" stated
}

case_report_for_people() {
    small_dem dem.tif
    run import dem.tif
    expect_exit 0
    local what
    for what in files CRS samples 'no data' 'vertical unit' 'vertical datum' heights extent triangles bounds time memory; do
        expect_match stdout "^$what  +[^ ]"
    done
    expect_match stdout '^vertical datum +EGM96 geoid \(assumed: state vertical_datum to be sure\)$'
}

case_no_data_makes_holes() {
    small_dem dem.tif -a_nodata 4260
    run import dem.tif --json
    # Each of the four cells around the hole keeps the triangle of its other three corners.
    expect_equal 'triangles' "$(json /triangles)" $((139 * 139 * 2 - 4))
    expect_equal 'samples' "$(json /samples/valid)" $((140 * 140 - 1))
    run import dem.tif --no-data -9999 --json
    expect_equal 'triangles' "$(json /triangles)" $((139 * 139 * 2))
}

case_second_import_is_prepared_already() {
    small_dem dem.tif
    run import dem.tif
    expect_no_match stdout 'prepared earlier'
    run import dem.tif
    expect_match stdout '^time +[0-9.]+ s \(prepared earlier; inputs unchanged\)$'
    mv dem.tif renamed.tif
    run import renamed.tif --json
    expect_equal 'found by content, not by name' "$(json /from_cache)" true
    expect_equal 'but reported by name' "$(json /files)" '["renamed.tif"]'
    small_dem renamed.tif -scale 0 1 1 2
    run import renamed.tif --json
    expect_equal 'changed content' "$(json /from_cache)" false
}

case_document_round_trip() {
    small_dem dem.tif
    run import dem.tif --vertical-datum ellipsoid --no-data -9999 --vertical-unit m --band 1 -o sub/terrain.yaml --json
    expect_exit 0
    expect_line stderr 'wrote sub/terrain.yaml'
    local triangles up
    triangles=$(json /triangles) up=$(json /bounds_m/up)
    run import sub/terrain.yaml -o again.yaml --json
    expect_exit 0
    expect_equal 'from the cache: nothing that matters is lost' "$(json /from_cache)" true
    expect_equal 'triangles' "$(json /triangles)" "$triangles"
    expect_equal 'heights' "$(json /bounds_m/up)" "$up"
    expect_equal 'datum' "$(json /vertical_datum/known)" stated
    expect_equal 'the same document from another folder' "$(sed 's/sub.//' again.yaml)" "$(sed 's/[.][.].//' sub/terrain.yaml)"
}

case_options_amend_a_document() {
    small_terrain
    run import terrain.yaml --vertical-datum ellipsoid --json
    expect_exit 0
    expect_match stdout '"name": ".*[Ee]llipsoid'
    run import terrain.yaml --band 2
    expect_exit 2
    expect_match stderr 'band'
    run import terrain.yaml dem.tif
    refused 'terrain.yaml: a terrain document is imported alone, not together with other files'
}

case_two_rasters_side_by_side() {
    gdal_translate -q -srcwin 210 520 70 140 "$shipped_dem" west.tif
    gdal_translate -q -srcwin 280 520 70 140 "$shipped_dem" east.tif
    run import west.tif east.tif --json
    expect_exit 0
    expect_equal 'triangles, none missing at the seam' "$(json /triangles)" $((139 * 139 * 2))
}

case_terrain_that_ships() {
    run import "$project/terrain/blanca_peak.yaml" --json
    expect_exit 0
    expect_equal 'triangles' "$(json /triangles)" $((693 * 679 * 2))
    expect_equal 'datum' "$(json /vertical_datum/known)" stated
}
