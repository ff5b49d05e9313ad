# The contact sheet and the movie at the end of a render.

movie_frames() {
    ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=nb_read_frames -of csv=p=0 "$1"
}

render_with_previews() { run render shot.yaml --set output.contact_sheet=true --set output.movie=true "$@"; }

case_movie_and_contact_sheet() {
    small_shot
    render_with_previews
    expect_exit 0
    expect_equal 'pictures in the movie' "$(movie_frames out/shot.mp4)" 6
    local facts
    facts=$(ffprobe -v error -select_streams v:0 -show_entries stream=codec_name,width,height,avg_frame_rate \
        -of csv=p=0 out/shot.mp4)
    expect_equal 'movie' "$facts" 'h264,64,36,24/1'
    expect_match <(oiiotool --info out/shot.contact.png) ' x .*, 3 channel, uint8 png$'
    expect_clean_folder out
}

case_follow_the_frames_that_there_are() {
    small_shot
    render_with_previews --frames 2-4
    expect_exit 0
    expect_equal 'pictures' "$(movie_frames out/shot.mp4)" 3
    render_with_previews
    expect_equal 'pictures' "$(movie_frames out/shot.mp4)" 6
}

case_frames_of_an_earlier_version_are_left_out() {
    small_shot
    render_with_previews
    render_with_previews --set image.width=48 --frames 2-4
    expect_exit 0
    expect_equal 'pictures' "$(movie_frames out/shot.mp4)" 3
}

case_made_when_missing_and_kept_when_not() {
    small_shot
    run render shot.yaml
    render_with_previews
    expect_exit 0
    expect test -s out/shot.contact.png
    expect_equal 'pictures' "$(movie_frames out/shot.mp4)" 6
    stat -c '%n %y' out/* >before
    render_with_previews
    expect_equal 'files are as they were' "$(stat -c '%n %y' out/*)" "$(cat before)"
}

case_made_again_when_older_than_a_frame() {
    small_shot
    render_with_previews
    touch -d '1 hour ago' out/shot.mp4
    render_with_previews
    expect test out/shot.mp4 -nt out/shot.0006.exr
}

case_say_which_view_they_show() {
    small_shot
    unset OCIO
    run render shot.yaml
    expect_no_match stderr '^preview: '
    render_with_previews
    expect_match stderr '^preview: (sRGB; OpenColorIO 2[.]1[0-9.]* has no built-in configuration|.*, by OpenColorIO.s ocio://default)$'
}

# A configuration whose only view shows everything in the red that it is told.
red_configuration() {
    cat >red.ocio <<'END_OF_CONFIGURATION'
ocio_profile_version: 2
roles: {default: raw}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays:
  Monitor:
    - !<View> {name: Red, colorspace: red}
colorspaces:
  - !<ColorSpace> {name: raw}
  - !<ColorSpace> {name: lin_rec709_scene}
  - !<ColorSpace>
    name: red
    from_scene_reference: !<MatrixTransform>
      {matrix: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1], offset: [0.5, 0, 0, 0]}
END_OF_CONFIGURATION
}

# The levels of a pixel of the first thumbnail.
levels_in_sheet() { oiiotool out/shot.contact.png --cut 1x1+160+20 --printstats | sed -n 's/^ *Stats Max: *//p' | cut -d' ' -f1-3; }

case_a_view_of_a_configuration() {
    small_shot
    red_configuration
    render_with_previews --set output.preview.ocio_config=red.ocio
    expect_exit 0
    expect_line stderr "preview: Monitor, Red, by OpenColorIO's red.ocio"
    expect_equal 'levels' "$(levels_in_sheet)" '0.501961 0.000000 0.000000'
    # Another view: the frames stay, the previews are made again.
    unset OCIO
    render_with_previews --json
    expect_equal 'rendered' "$(json /frames/rendered)" 0
    expect test "$(levels_in_sheet)" != '0.501961 0.000000 0.000000'
    OCIO=red.ocio render_with_previews
    expect_equal 'levels' "$(levels_in_sheet)" '0.501961 0.000000 0.000000'
}

case_a_view_that_is_not_there() {
    small_shot
    red_configuration
    render_with_previews --set output.preview.ocio_config=red.ocio --set output.preview.view=Film
    refused "red.ocio: output.preview.view: got 'Film', allowed Red"
    expect test ! -e out
}

case_burn_in_is_no_part_of_frames() {
    small_shot
    render_with_previews
    cp -r out before
    render_with_previews --set output.burn_in=true --json
    expect_equal 'rendered' "$(json /frames/rendered)" 0
    expect_same_frames out/shot.0003.exr before/shot.0003.exr
    ! cmp -s out/shot.contact.png before/shot.contact.png || fail 'the contact sheet is as it was'
    ! cmp -s out/shot.mp4 before/shot.mp4 || fail 'the movie is as it was'
    stat -c '%n %y' out/* >times
    render_with_previews --set output.burn_in=true
    expect_equal 'files are as they were' "$(stat -c '%n %y' out/*)" "$(cat times)"
}
