/// Volumes for tests of surfaces in them, and the surface taken from one.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "render_core/scene/isosurface.hpp"

namespace tedavis::test_support {

struct Volume {
    std::uint32_t nx, ny, nz;
    std::vector<float> values;

    Volume(std::uint32_t columns, std::uint32_t rows, std::uint32_t slices, float value = 0)
        : nx(columns), ny(rows), nz(slices), values(std::size_t{columns} * rows * slices, value) {}
    [[nodiscard]] float& at(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return values[(std::size_t{z} * ny + y) * nx + x];
    }
    [[nodiscard]] scene::VolumeView view() const { return {{values.data(), values.size()}, nx, ny, nz}; }
};

/// Of a function of places in the grid.
template <class F>
Volume sampled_volume(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, F value) {
    Volume volume(nx, ny, nz);
    for (std::uint32_t z = 0; z < nz; ++z)
        for (std::uint32_t y = 0; y < ny; ++y)
            for (std::uint32_t x = 0; x < nx; ++x) volume.at(x, y, z) = static_cast<float>(value(glm::dvec3(x, y, z)));
    return volume;
}

/// Independent values in [0, 1) with a border of -1.
inline Volume noise_volume(std::uint32_t side, unsigned seed) {
    std::mt19937 random(seed);
    Volume volume(side, side, side, -1);
    for (std::uint32_t z = 1; z + 1 < side; ++z)
        for (std::uint32_t y = 1; y + 1 < side; ++y)
            for (std::uint32_t x = 1; x + 1 < side; ++x)
                volume.at(x, y, z) = static_cast<float>(random() >> 8) / static_cast<float>(1u << 24);
    return volume;
}

struct MadeSurface {
    std::vector<scene::IsosurfaceVertex> vertices;
    std::vector<std::uint32_t> indices;
    scene::IsosurfaceCounts counts;
    scene::IsosurfaceProgress progress = scene::IsosurfaceProgress::more;

    [[nodiscard]] std::size_t triangles() const { return indices.size() / 3; }
    [[nodiscard]] glm::dvec3 corner(std::size_t triangle, std::size_t n) const {
        return glm::dvec3(vertices[indices[3 * triangle + n]].position);
    }
    /// Twice the area, towards the outside.
    [[nodiscard]] glm::dvec3 across(std::size_t triangle) const {
        return glm::cross(corner(triangle, 1) - corner(triangle, 0), corner(triangle, 2) - corner(triangle, 0));
    }
    [[nodiscard]] double area() const {
        double sum = 0;
        for (std::size_t n = 0; n < triangles(); ++n) sum += glm::length(across(n)) / 2;
        return sum;
    }
    /// Of a closed surface, by the divergence theorem; positive when triangles face outwards.
    [[nodiscard]] double enclosed() const {
        double sum = 0;
        for (std::size_t n = 0; n < triangles(); ++n) sum += glm::dot(corner(n, 0), across(n)) / 6;
        return sum;
    }
};

/// A builder with memory of its own.
class SurfaceMaker {
public:
    SurfaceMaker(std::uint32_t nx, std::uint32_t ny) : memory_(scene::IsosurfaceBuilder::bytes_needed(nx, ny)) {
        base::Arena arena(memory_.data(), memory_.size());
        started_ = builder.start(arena, nx, ny);
    }
    [[nodiscard]] bool started() const { return started_; }
    /// In steps of so many cells, into room for so much.
    MadeSurface make(const Volume& volume, float level, std::uint64_t step, std::size_t room_vertices, std::size_t room_indices) {
        MadeSurface made;
        made.vertices.resize(room_vertices);
        made.indices.resize(room_indices);
        if (builder.begin(volume.view(), level, {made.vertices, made.indices}) != scene::IsosurfaceError::none) return made;
        do {
            made.progress = builder.step(step);
        } while (builder.cells_left() > 0);
        made.counts = builder.counts();
        made.vertices.resize(made.counts.vertices);
        made.indices.resize(made.counts.indices);
        return made;
    }

    scene::IsosurfaceBuilder builder;

private:
    std::vector<std::uint8_t> memory_;
    bool started_ = false;
};

/// All at once, with room for whatever the volume holds.
inline MadeSurface surface_of(const Volume& volume, float level) {
    SurfaceMaker maker(volume.nx, volume.ny);
    const std::size_t cells = volume.values.size();
    return maker.make(volume, level, ~std::uint64_t{0}, 7 * cells, 36 * cells);
}

}  // namespace tedavis::test_support
