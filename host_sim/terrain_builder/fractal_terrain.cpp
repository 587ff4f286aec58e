#include "host_sim/terrain_builder/fractal_terrain.hpp"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <memory>
#include <random>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr float kCell_m = 30;              // about a second of arc
constexpr float kSteepness = 0.075f;       // of the first displacement, over the side
constexpr float kRoughness = 0.5f;         // displacement of a step over that of the step before
constexpr float kEdgeDisplacement = 0.7f;  // midpoints of edges lie sqrt(2) closer to their neighbours than centres do
constexpr float kHighest_m = 4000;

/// A lattice of 2^n + 1 posts a side, refined step by step.
class Refinement {
public:
    Refinement(std::uint32_t cells, std::uint64_t seed)
        : cells_(cells), posts_(cells + 1), height_m_(std::size_t{posts_} * posts_, 0.0f), random_(seed) {}

    void run(const FractalProgress& progress) {
        float amplitude_m = kSteepness * kCell_m * static_cast<float>(cells_);
        for (std::uint32_t step = cells_; step > 1; step /= 2, amplitude_m *= kRoughness) {
            displace_centres(step, amplitude_m);
            displace_edges(step, amplitude_m * kEdgeDisplacement);
            if (progress) progress(cells_ / step, cells_);
        }
    }
    [[nodiscard]] float at(std::uint32_t i, std::uint32_t j) const { return height_m_[std::size_t{j} * posts_ + i]; }

private:
    float& post(std::uint32_t i, std::uint32_t j) { return height_m_[std::size_t{j} * posts_ + i]; }

    /// From -amplitude to amplitude, of the engine's own bits: library distributions differ between implementations.
    float jitter(float amplitude_m) { return amplitude_m * (static_cast<float>(random_() >> 40) / 8388608.0f - 1.0f); }

    void displace_centres(std::uint32_t step, float amplitude_m) {
        const std::uint32_t half = step / 2;
        for (std::uint32_t j = half; j < posts_; j += step) {
            for (std::uint32_t i = half; i < posts_; i += step) {
                const float corners =
                    post(i - half, j - half) + post(i + half, j - half) + post(i - half, j + half) + post(i + half, j + half);
                post(i, j) = 0.25f * corners + jitter(amplitude_m);
            }
        }
    }

    void displace_edges(std::uint32_t step, float amplitude_m) {
        const std::uint32_t half = step / 2;
        for (std::uint32_t j = 0; j < posts_; j += half) {
            for (std::uint32_t i = (j / half) % 2 == 0 ? half : 0; i < posts_; i += step) {
                post(i, j) = mean_of_neighbours(i, j, half) + jitter(amplitude_m);
            }
        }
    }

    /// Of those inside: three on the border, else four.
    [[nodiscard]] float mean_of_neighbours(std::uint32_t i, std::uint32_t j, std::uint32_t distance) {
        float sum = 0;
        int count = 0;
        const auto add = [&](bool inside, std::uint32_t a, std::uint32_t b) {
            if (!inside) return;
            sum += post(a, b);
            ++count;
        };
        add(i >= distance, i - distance, j);
        add(i + distance < posts_, i + distance, j);
        add(j >= distance, i, j - distance);
        add(j + distance < posts_, i, j + distance);
        return sum / static_cast<float>(count);
    }

    std::uint32_t cells_, posts_;
    std::vector<float> height_m_;
    std::mt19937_64 random_;
};

/// The lowest post becomes 0; what is higher than the highest is made lower in proportion.
void settle(std::vector<float>& height_m) {
    const auto [lowest, highest] = std::minmax_element(height_m.begin(), height_m.end());
    const float base_m = *lowest, scale = std::min(1.0f, kHighest_m / std::max(1.0f, *highest - base_m));
    for (float& h : height_m) h = (h - base_m) * scale;
}

using Dataset = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

bool write_raster(const FractalTerrain& terrain, const std::string& path) {
    const int posts = static_cast<int>(terrain.posts);
    Dataset file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), posts, posts, 1, GDT_Float32, nullptr));
    if (file == nullptr) return false;
    // Posts are the centres of pixels.
    double transform[6] = {kFractalWest_deg - 0.5 * kFractalStep_deg,
                           kFractalStep_deg,
                           0,
                           kFractalNorth_deg + 0.5 * kFractalStep_deg,
                           0,
                           -kFractalStep_deg};
    file->SetGeoTransform(transform);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    file->SetSpatialRef(&wgs84);
    const bool written =
        file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, posts, posts, const_cast<float*>(terrain.height_m.data()), posts, posts,
                                         GDT_Float32, 0, 0) == CE_None;
    file.reset();
    return written && CPLGetLastErrorType() < CE_Failure;
}

}  // namespace

FractalTerrain make_fractal_terrain(std::uint32_t posts, std::uint64_t seed, const FractalProgress& progress) {
    std::uint32_t cells = 2;
    while (cells + 1 < posts) cells *= 2;
    Refinement refinement(cells, seed);
    refinement.run(progress);
    FractalTerrain terrain;
    terrain.posts = posts;
    terrain.height_m.reserve(std::size_t{posts} * posts);
    for (std::uint32_t j = 0; j < posts; ++j)
        for (std::uint32_t i = 0; i < posts; ++i) terrain.height_m.push_back(refinement.at(i, j));
    settle(terrain.height_m);
    return terrain;
}

std::string fractal_geotiff(const FractalTerrain& terrain) {
    GDALAllRegister();
    const QuietGdal quiet;
    const std::string path = "/vsimem/fractal_terrain.tif";
    const bool written = write_raster(terrain, path);
    vsi_l_offset bytes = 0;
    const GByte* const data = VSIGetMemFileBuffer(path.c_str(), &bytes, FALSE);
    std::string image;
    if (written && data != nullptr) image.assign(reinterpret_cast<const char*>(data), static_cast<std::size_t>(bytes));
    VSIUnlink(path.c_str());
    if (image.empty()) throw UserError("terrain fractal: the raster does not fit the memory; give a smaller --size");
    return image;
}

}  // namespace tedavis::host_sim
