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
