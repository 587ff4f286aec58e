/// Places with values for glyphs, a view over them, and fields put together of them.
#pragma once

#include <glm/geometric.hpp>
#include <random>
#include <stdexcept>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::test_support {

inline const earth::Geodetic kGlyphAnchor{base::radians(46.8), base::radians(9.8), earth::EllipsoidHeight{1500}};

/// A block of memory and a field in it.
struct HeldField {
    explicit HeldField(std::uint32_t most_sites) : block(scene::GlyphField::bytes_needed(most_sites)) {
        base::Arena arena(block.data(), block.size());
        if (!field.start(arena, most_sites)) throw std::runtime_error("no field of so many sites");
    }
    /// In steps of so many sites.
    void fill(const std::vector<scene::GlyphSite>& sites, const scene::GlyphFrame& frame, scene::GlyphValues values,
              std::uint32_t step = 1u << 20) {
        field.begin(frame, values);
        for (const scene::GlyphSite& site : sites) field.add(site);
        while (field.step(step) == scene::GlyphProgress::more) {
        }
    }
    std::vector<unsigned char> block;
    scene::GlyphField field;
};

struct HeldSelection {
    explicit HeldSelection(std::uint32_t most) : block(scene::GlyphSelection::bytes_needed(most)) {
        base::Arena arena(block.data(), block.size());
        if (!selection.start(arena, most)) throw std::runtime_error("no selection of so many glyphs");
    }
    std::vector<unsigned char> block;
    scene::GlyphSelection selection;
};

/// Wind on a lattice over the anchor: curved streams, faster with height, some of it missing.
inline std::vector<scene::GlyphSite> wind_lattice(const scene::GlyphFrame& frame, int columns, int rows, int levels,
                                                  double spacing_m, double level_m) {
    std::vector<scene::GlyphSite> sites;
    for (int k = 0; k < levels; ++k)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                scene::GlyphSite site;
                const glm::dvec3 local((i - 0.5 * (columns - 1)) * spacing_m, (j - 0.5 * (rows - 1)) * spacing_m, k * level_m);
                site.place = frame.anchor + frame.axes * local;
                const double turn = 4.0 * i / columns + 3.0 * j / rows + 0.3 * k, speed = 4 + 3 * k + 3 * std::sin(0.05 * j);
                site.value = static_cast<float>(speed * std::sin(turn));
                site.north_mps = static_cast<float>(speed * std::cos(turn));
                site.size_m = static_cast<float>(0.8 * spacing_m);
                site.uncertainty = scene::Uncertainty::from_level(double(i) / columns);
                if ((i * 7 + j * 13 + k) % 29 == 0) site.value = std::nanf("");
                sites.push_back(site);
            }
    return sites;
}

/// Numbers at random places; each site's number is its own.
inline std::vector<scene::GlyphSite> scattered_numbers(const scene::GlyphFrame& frame, int count, double reach_m, double height_m,
                                                       unsigned seed = 3) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-reach_m, reach_m), up(0, height_m), size(20, 200);
    std::vector<scene::GlyphSite> sites;
    for (int n = 0; n < count; ++n) {
        scene::GlyphSite site;
        const double east = across(random), north = across(random);
        site.place = frame.anchor + frame.axes * glm::dvec3(east, north, up(random));
        site.value = static_cast<float>(n);
        site.size_m = static_cast<float>(size(random));
        site.uncertainty = scene::Uncertainty::from_code(static_cast<std::uint8_t>(random() % 255));
        sites.push_back(site);
    }
    return sites;
}

/// From a place along the frame's axes, looking at another.
inline scene::GlyphView glyph_view(const scene::GlyphFrame& frame, const glm::dvec3& from, const glm::dvec3& to,
                                   double focal_px = 900, double width_px = 1024, double height_px = 768) {
    scene::GlyphView view;
    view.eye = frame.anchor + frame.axes * from;
    view.forward = frame.axes * glm::normalize(to - from);
    view.right = glm::normalize(glm::cross(view.forward, frame.axes[2]));
    view.down = glm::cross(view.forward, view.right);
    view.focal_px = focal_px;
    view.half_width_tangent = 0.5 * width_px / focal_px;
    view.half_height_tangent = 0.5 * height_px / focal_px;
    view.near_m = 5;
    view.far_m = 400000;
    return view;
}

/// Straight from the definition: the sphere round a glyph reaches into the view.
inline bool sees_sphere(const scene::GlyphView& view, const earth::Ecef& place, double radius_m) {
    const glm::dvec3 from_eye = place - view.eye;
    const double ahead = glm::dot(from_eye, view.forward);
    if (ahead < view.near_m - radius_m || ahead > view.far_m + radius_m) return false;
    const auto within = [&](double across, double tangent) {
        return (std::abs(across) - tangent * ahead) / std::hypot(1.0, tangent) <= radius_m;
    };
    return within(glm::dot(from_eye, view.right), view.half_width_tangent) &&
           within(glm::dot(from_eye, view.down), view.half_height_tangent);
}

}  // namespace tedavis::test_support
