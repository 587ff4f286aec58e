/// Builds isosurfaces of a scene's field for the element's levels, from the lowest (outermost) on, each more opaque than the
/// one before. The values are those of the element's attribute, or of the layer's first one.
///
/// Grids with several times are built for the frame's minute, every frame, of kMaxMovingPosts posts at most; others once. Where
/// a grid has more posts than there is room for, or its surface more vertices, every second, third ... post is used. Normals
/// are those of the field in space. The colour is that of the scale at the level, faded by the field's uncertainty at a vertex.
/// Atmospheric layers are so flat that shading does not show their form: from half detail on a surface has lines of equal
/// height, all of them or, where there is no room, none. Below full detail only the first of the design's levels are shown.
///
/// Counts are posts at one time: drawn are those used, aggregated those skipped, hidden those without a value and all posts of
/// a grid that shows nothing.
/// Memory  from an arena, once. Thread  the ground's. Bounded: posts and surfaces, kMaxIsosurfaceSteps times.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/scene/grid_field.hpp"
#include "render_core/scene/isosurface.hpp"

namespace tedavis::draw {

inline constexpr std::uint32_t kMaxMovingPosts = 8192;
inline constexpr std::uint32_t kMaxIsosurfaceSteps = 64;  ///< largest step between used posts, and number of tries

/// Height difference between lines of equal height: 1000 ft.
inline constexpr double kIsosurfaceLines_m = 304.8;
/// True from half detail on, except for elements with the surface grid.
[[nodiscard]] bool has_isosurface_lines(const design::DataElement& element);

struct IsosurfaceRoom {
    std::uint32_t posts = 0, posts_of_slice = 0, vertices = 0;

    /// Room for batches of so many vertices.
    [[nodiscard]] static IsosurfaceRoom beside(std::uint32_t batch_vertices);
};

class IsosurfaceSolids {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(const IsosurfaceRoom& room);
    [[nodiscard]] bool start(base::Arena& arena, const IsosurfaceRoom& room);

    [[nodiscard]] ElementCount add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

private:
    /// The sampling: every n-th post along each axis.
    struct Sampling {
        std::uint32_t step[3] = {1, 1, 1}, posts[3] = {};

        [[nodiscard]] std::uint64_t all() const { return std::uint64_t{posts[0]} * posts[1] * posts[2]; }
    };
    [[nodiscard]] static Sampling sampling_of(const scene::GridShape& grid, std::uint32_t step);
    /// Returns how many values there are.
    std::uint32_t sample(const scene::GridField& field, const Sampling& sampling);
    [[nodiscard]] bool build(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const scene::GridField& field,
                             const Sampling& sampling);
    [[nodiscard]] bool make(const Sampling& sampling, float level, std::size_t room);
    void add_surface(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const scene::GridField& field,
                     const Sampling& sampling);
    std::uint16_t add_vertex(SolidMesh& mesh, const ElementInput& input, const scene::GridField& field, const Sampling& sampling,
                             const scene::IsosurfaceVertex& vertex);
    struct GridPlace {
        double latitude_rad = 0, longitude_rad = 0;
        double height_m = 0;  ///< in the layer's datum
        double climb_m = 0;   ///< from the level below to the one above
        glm::dvec3 place{0};  ///< ECEF
    };
    [[nodiscard]] GridPlace placed_in(const ElementInput& input, const Sampling& sampling,
                                      const scene::IsosurfaceVertex& vertex) const;

    [[nodiscard]] static glm::dvec3 normal_in(const ElementInput& input, const Sampling& sampling, const GridPlace& at,
                                              const glm::vec3& normal);
    /// A piece of a line of equal height, within a triangle.
    struct LinePiece {
        scene::IsosurfaceVertex ends[2];
    };
    void add_lines(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const Sampling& sampling);
    template <class Visitor>
    void visit_lines(const ElementInput& input, const Sampling& sampling, std::uint32_t first, Visitor visitor) const;
    void add_line(SolidMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& normal) const;

    scene::IsosurfaceBuilder builder_;
    base::Span<float> values_;
    base::Span<scene::IsosurfaceVertex> vertices_;
    base::Span<std::uint32_t> indices_;
    base::Span<std::uint32_t> slots_;  ///< by vertex: its number in a mesh, with the number of the mesh
    std::uint32_t slice_posts_ = 0;
    std::int64_t time_ns_ = 0;
    design::Color color_;
    bool has_uncertainty_ = false;
};

[[nodiscard]] bool shows_isosurfaces(const scene::Layer& layer);
/// True where they are built again in every frame.
[[nodiscard]] bool isosurfaces_move(const scene::Layer& layer);

}  // namespace tedavis::draw
