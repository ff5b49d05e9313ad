#include "shot/many_looks.h"

namespace overfly {

void ManyLooks::look(std::span<const SceneShader::Look> looks, std::span<Radiance> out) {
    looks_ = looks;
    out_ = out;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        if (looks[i].sighting.is_of_ground()) {
            look_at_ground(i);
        } else {
            look_at_others(i);
        }
    }
    meet();
    finish();
}

void ManyLooks::look_at_ground(std::size_t i) {
    const SceneShader::Look& look = looks_[i];
    const std::size_t k = ground_count_;
    ground_.x[k] = look.sighting.x;
    ground_.y[k] = look.sighting.y;
    ground_.u[k] = camera_->u_at(look.time_s);
    ground_.triangles.set(k, *shader_->mesh_, look.sighting.seen->triangle);
    on_ground_[k] = static_cast<std::uint32_t>(i);
    if (++ground_count_ == GroundLooks::kSize) meet();
}

// Those that look at the ground find their place on it, and its light.
void ManyLooks::meet() {
    meet_ground(*camera_, shader_->daylight_->to_sun(), shader_->lowest_m_, ground_, ground_count_);
    for (std::size_t k = 0; k < ground_count_; ++k) {
        const std::size_t i = on_ground_[k];
        const RasterPlace met = {ground_.met_column[k], ground_.met_row[k]};
        const LitGround::Place place = shader_->light_->at(met, looks_[i].sighting.seen->in_shadow);
        out_[i] = {{}, 1.0F, static_cast<float>(ground_.depth_m[k])};
        add_view(i, place.radiance,
                 {static_cast<float>(ground_.distance_m[k]), static_cast<float>(ground_.from_height_m[k]),
                  place.height_m, static_cast<float>(ground_.towards_sun[k])});
    }
    ground_count_ = 0;
}

void ManyLooks::look_at_others(std::size_t i) {
    const SceneShader::Behind behind = shader_->behind_air(*camera_, looks_[i]);
    out_[i] = behind.radiance;
    if (!behind.air) return;
    const Daylight::AirPath& air = *behind.air;
    add_view(
        i, behind.radiance.colour,
        {static_cast<float>(air.distance_m), static_cast<float>(air.from_height_m), static_cast<float>(air.to_height_m),
         static_cast<float>(dot(behind.direction, shader_->daylight_->to_sun()))});
}

void ManyLooks::add_view(std::size_t i, Rgb behind, const AirViews::Path& path) {
    views_.set(view_count_, behind, path);
    in_air_[view_count_] = static_cast<std::uint32_t>(i);
    if (++view_count_ == AirViews::kSize) finish();
}

// Those that look through air see what is left.
void ManyLooks::finish() {
    look_through(shader_->daylight_->air(), views_, view_count_);
    for (std::size_t k = 0; k < view_count_; ++k) out_[in_air_[k]].colour = views_.seen(k);
    view_count_ = 0;
}

}  // namespace overfly
