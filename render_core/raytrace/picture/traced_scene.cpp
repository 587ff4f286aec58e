#include "render_core/raytrace/picture/traced_scene.hpp"

#include "render_core/raytrace/surface/surface_bounds.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint64_t kAlignments = 256;  // that an arena may lose between arrays

bool is_same_noise(const MicroNoise& a, const MicroNoise& b) {
    return a.kind == b.kind && a.octaves == b.octaves && a.seed == b.seed && a.amplitude == b.amplitude &&
           a.frequency == b.frequency && a.gain == b.gain && a.first_column == b.first_column && a.first_row == b.first_row;
}

bool is_same_relief(const ReliefMap& a, const ReliefMap& b) {
    return a.tile.posts == b.tile.posts && a.full_scale == b.full_scale && a.amplitude == b.amplitude && a.density == b.density;
}

bool is_same_surface(const SurfaceSettings& a, const SurfaceSettings& b) {
    return a.kind == b.kind && a.subdivisions == b.subdivisions && a.micro.kind == b.micro.kind &&
           is_same_noise(a.micro.noise, b.micro.noise) && is_same_relief(a.micro.relief, b.micro.relief);
}

}  // namespace

template <class Height>
struct TracedScene<Height>::Needs {
    const SurfaceSettings* stored = nullptr;
    const SurfaceSettings* smooth = nullptr;
    SearchSettings search;  ///< of the smooth one
    bool has_triangles = false, has_bilinear = false, has_sky = false, has_apertures = false, has_averages = false;
    bool is_of_one_surface = true, is_stored_exact = true;

    [[nodiscard]] bool has_cones() const { return smooth != nullptr && search.kind == SearchKind::cones; }
};

template <class Height>
typename TracedScene<Height>::Needs TracedScene<Height>::needs_of(base::Span<const TraceSettings> settings) {
    Needs needs;
    for (const TraceSettings& one : settings) {
        if (one.is_surface_stored || !is_kernel_surface(one)) {
            const SurfaceSettings*& surface = one.is_surface_stored ? needs.stored : needs.smooth;
            const bool is_first = surface == nullptr, is_smooth = !one.is_surface_stored;
            needs.is_of_one_surface =
                needs.is_of_one_surface &&
                (is_first || (is_same_surface(*surface, one.surface) && (!is_smooth || needs.search == one.search)));
            needs.is_stored_exact = needs.is_stored_exact && (is_smooth || one.search.is_exact());
            if (is_smooth) needs.search = one.search;
            surface = &one.surface;
        } else {
            (one.surface.kind == SurfaceKind::two_triangles ? needs.has_triangles : needs.has_bilinear) = true;
        }
        needs.has_sky = needs.has_sky || one.ambient != Ambient::none;
        needs.has_apertures = needs.has_apertures || one.ambient == Ambient::apertures;
        needs.has_averages = needs.has_averages || one.antialiasing == Antialiasing::average_mipmap;
    }
    return needs;
}

template <class Height>
std::uint64_t TracedScene<Height>::bytes_needed(const HeightGrid<Height>& grid, base::Span<const TraceSettings> settings) {
    const Needs needs = needs_of(settings);
    const std::uint64_t maxima = HeightMipmap<Height>::bytes_needed(grid.columns, grid.rows);
    std::uint64_t bytes = kAlignments * (kMaxItems + 1);
    if (needs.has_triangles || needs.has_bilinear) bytes += maxima;
    if (needs.stored != nullptr) {
        const std::uint64_t parts = needs.stored->subdivisions;
        bytes += StoredSurface<Height>::bytes_needed(grid, needs.stored->subdivisions) +
                 HeightMipmap<float>::bytes_needed(static_cast<std::uint32_t>((grid.columns - 1) * parts + 1),
                                                   static_cast<std::uint32_t>((grid.rows - 1) * parts + 1));
    }
    if (needs.smooth != nullptr) bytes += maxima;
    if (needs.has_cones()) bytes += ConeMap<Height>::bytes_needed(grid.columns, grid.rows);
    if (needs.has_sky) bytes += SkyMap<Height>::bytes_needed(grid.columns, grid.rows, needs.has_apertures);
    if (needs.has_averages) bytes += AverageMipmap<Height>::bytes_needed(grid.columns, grid.rows);
    return bytes;
}

template <class Height>
void TracedScene<Height>::note(const char* name, std::uint64_t before, const base::Arena& arena) {
    const bool is_noted = items_.try_push_back({name, arena.use().in_use - before});
    TEDAVIS_CHECK(is_noted);
}

template <class Height>
bool TracedScene<Height>::start_posts(base::Arena& arena) {
    const std::uint64_t before = arena.use().in_use;
    if (!maxima_.start(grid_, arena)) return false;
    note("maximum mipmap", before, arena);
    triangles_.start({&maxima_, nullptr, CellSurface::two_triangles}, 1, size_.width, size_.height);
    bilinear_.start({&maxima_, nullptr, CellSurface::bilinear}, 1, size_.width, size_.height);
    return true;
}

template <class Height>
bool TracedScene<Height>::start_stored(base::Arena& arena) {
    const std::uint64_t before = arena.use().in_use;
    if (!stored_.start(grid_, stored_settings_, arena)) return false;
    note("stored surface", before, arena);
    const std::uint64_t between = arena.use().in_use;
    if (!stored_maxima_.start(stored_.grid(), arena)) return false;
    note("maximum mipmap of it", between, arena);
    fine_.start({&stored_maxima_, nullptr, CellSurface::bilinear}, stored_.parts(), size_.width, size_.height);
    return true;
}

template <class Height>
bool TracedScene<Height>::start_smooth(base::Arena& arena) {
    const std::uint64_t before = arena.use().in_use;
    if (!smooth_maxima_.start(grid_, arena, surface_bounds<Height>(smooth_settings_))) return false;
    smooth_.start(smooth_maxima_, smooth_settings_, size_.width);
    note("bounds of the surface", before, arena);
    const std::uint64_t between = arena.use().in_use;
    if (has_cones_) {
        if (!cones_.start(grid_, {}, arena)) return false;
        note("cones", between, arena);
    }
    smooth_.set_search(smooth_search_, has_cones_ ? &cones_ : nullptr);
    return true;
}

template <class Height>
bool TracedScene<Height>::start_maps(const Needs& needs, base::Arena& arena) {
    std::uint64_t before = arena.use().in_use;
    if (has_sky_) {
        const SkyMapSettings sky = {size_.sky_azimuths, size_.sky_radius, scale_, needs.has_apertures};
        if (!sky_.start(grid_, sky, arena)) return false;
        note(needs.has_apertures ? "sky view and apertures" : "sky view", before, arena);
    }
    before = arena.use().in_use;
    if (has_averages_) {
        if (!averages_.start(grid_, arena)) return false;
        note("average mipmap", before, arena);
    }
    return true;
}

template <class Height>
typename TracedScene<Height>::Answer TracedScene<Height>::check_size(const SceneSize& size) {
    if (size.width == 0 || size.height == 0 || size.width > SceneSize::kMaxSide || size.height > SceneSize::kMaxSide)
        return base::fail(base::FaultText("a traced picture is 1 to 16384 pixels wide and high; change its size"));
    return std::uint64_t{0};
}

template <class Height>
typename TracedScene<Height>::Answer TracedScene<Height>::check_needs(const HeightGrid<Height>& grid, const Needs& needs) {
    if (!needs.is_of_one_surface)
        return base::fail(base::FaultText("settings ask for two different stored or smooth surfaces or searches; give them one"));
    if (!needs.is_stored_exact)
        return base::fail(base::FaultText("a stored surface is searched exactly only; choose the exact search or the posts"));
    if (needs.has_cones() && needs.smooth->kind != SurfaceKind::bilinear)
        return base::fail(base::FaultText("cones stand over a bilinear surface only; choose it or another search"));
    if (needs.smooth != nullptr && !surface_fits(grid, *needs.smooth))
        return base::fail(
            base::FaultText("heights come too close to the limits of 16 bits for this surface; lower its amplitude"));
    return std::uint64_t{0};
}

template <class Height>
typename TracedScene<Height>::Answer TracedScene<Height>::start(const TracedTerrain& terrain, const GridScale& scale,
                                                                const TraceSettings& settings, const SceneSize& size) {
    if (!needs_primary_hits_only(settings))
        return base::fail(base::FaultText("settings need secondary rays or maps, which paged ground has not; choose others"));
    *this = TracedScene();
    other_terrain_ = &terrain;
    scale_ = scale;
    size_ = size;
    return check_size(size);
}

template <class Height>
typename TracedScene<Height>::Answer TracedScene<Height>::start(const HeightGrid<Height>& grid, const GridScale& scale,
                                                                base::Span<const TraceSettings> settings, const SceneSize& size,
                                                                base::Arena& arena) {
    const Needs needs = needs_of(settings);
    if (settings.empty()) return base::fail(base::FaultText("a traced scene needs at least one setting; give one"));
    if (const Answer checked = check_size(size); !checked.ok()) return checked;
    if (const Answer checked = check_needs(grid, needs); !checked.ok()) return checked;
    other_terrain_ = nullptr;
    grid_ = grid;
    scale_ = scale;
    size_ = size;
    items_ = {};
    has_triangles_ = needs.has_triangles;
    has_bilinear_ = needs.has_bilinear;
    has_stored_ = needs.stored != nullptr;
    has_smooth_ = needs.smooth != nullptr;
    has_cones_ = needs.has_cones();
    has_sky_ = needs.has_sky;
    has_averages_ = needs.has_averages;
    if (has_stored_) stored_settings_ = *needs.stored;
    if (has_smooth_) smooth_settings_ = *needs.smooth;
    smooth_search_ = needs.search;
    const std::uint64_t before = arena.use().in_use;
    const bool has_posts = !(has_triangles_ || has_bilinear_) || start_posts(arena);
    if (!has_posts || (has_stored_ && !start_stored(arena)) || (has_smooth_ && !start_smooth(arena)) || !start_maps(needs, arena))
        return base::fail(base::FaultText("the traced scene does not fit its memory; give it bytes_needed()"));
    return arena.use().in_use - before;
}

template <class Height>
void TracedScene<Height>::build(base::Workers& workers) {
    if (has_triangles_ || has_bilinear_) maxima_.build(workers);
    if (has_stored_) {
        stored_.build(workers);
        stored_maxima_.build(workers);
    }
    if (has_smooth_) smooth_maxima_.build(workers);
    if (has_cones_) cones_.build(workers);
    if (has_sky_) sky_.build(workers);
    if (has_averages_) averages_.build(workers);
}

template <class Height>
void TracedScene<Height>::set_view(const PictureSight& sight, const ViewKernel<Height>& kernel,
                                   const ViewKernel<float>& fine_kernel) {
    sight_ = sight;
    if (has_triangles_) triangles_.set_view(sight, kernel);
    if (has_bilinear_) bilinear_.set_view(sight, kernel);
    if (has_stored_) fine_.set_view(sight, fine_kernel);
    if (has_smooth_) smooth_.set_view(sight);
}

template <class Height>
const TracedTerrain& TracedScene<Height>::terrain(const TraceSettings& settings) const {
    if (other_terrain_ != nullptr) return *other_terrain_;
    const bool is_posts = is_kernel_surface(settings) && !settings.is_surface_stored;
    const bool is_triangles = settings.surface.kind == SurfaceKind::two_triangles;
    TEDAVIS_CHECK(is_posts ? (is_triangles ? has_triangles_ : has_bilinear_)
                           : (settings.is_surface_stored ? has_stored_ : has_smooth_));
    if (is_posts) return is_triangles ? triangles_ : bilinear_;
    if (settings.is_surface_stored) return fine_;
    return smooth_;
}

template <class Height>
ShadingMaps<Height> TracedScene<Height>::maps() const {
    return {has_sky_ ? &sky_ : nullptr, has_averages_ ? &averages_ : nullptr, scale_};
}

template <class Height>
std::uint64_t TracedScene<Height>::bytes() const {
    std::uint64_t sum = 0;
    for (const PreparedItem& item : items_) sum += item.bytes;
    return sum;
}

template class TracedScene<std::int16_t>;
template class TracedScene<float>;

}  // namespace tedavis::raytrace
