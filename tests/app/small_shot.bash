# Documents for the cases: ten kilometres around Blanca Peak cut from the terrain that ships, one second of flight, frames
# of a few pixels. Most of the time of a small render is the light on the ground, hence the cut.

shipped_dem=$project/terrain/blanca_peak_utm13n_75m.tif

small_dem() {  # small_dem FILE [OPTION of gdal_translate]...
    local file=$1
    shift
    gdal_translate -q -srcwin 210 520 140 140 "$@" "$shipped_dem" "$file"
}

small_terrain() {
    small_dem dem.tif
    printf 'dem: dem.tif\nvertical_datum: egm96\n' >terrain.yaml
}

small_flight() {
    cat >flight.yaml <<'END'
height_above: sea_level
lens: {hfov_deg: 60}
keyframes:
  - {time_s: 0, lon_deg: -105.53, lat_deg: 37.620, height_m: 4700, heading_deg: 140, pitch_deg: -12}
  - {time_s: 1, lon_deg: -105.51, lat_deg: 37.612, height_m: 4800, heading_deg: 150, pitch_deg: -14}
END
}

# small_shot [NAME]: NAME.yaml of six frames without previews, and the documents that it joins
small_shot() {
    local name=${1:-shot}
    [[ -e terrain.yaml ]] || small_terrain
    [[ -e flight.yaml ]] || small_flight
    cat >"$name.yaml" <<END
terrain: terrain.yaml
flight: flight.yaml
frames: {count: 6}
image: {width: 64, height: 36}
sampling: {lines: 1}
output: {folder: out, name: $name, contact_sheet: false, movie: false}
END
}
