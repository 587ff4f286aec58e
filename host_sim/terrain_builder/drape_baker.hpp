/// The drape stages of a build: pages of the finest level from the image, those above from the pages below them.
///
/// A texel of a coarser page is the weighted mean of the finer texels in its extent, with weights (1 2 1) x (1 2 1) / 16.
/// Neighbouring pages have equal texels on their common border.
#pragma once

#include <functional>
#include <optional>

#include "host_sim/terrain_builder/attribute_baker.hpp"
#include "host_sim/terrain_builder/drape_sampler.hpp"

namespace tedavis::host_sim {

class DrapeBaker {
public:
    /// Returns the place of the drape page of a chunk of the database that was made before.
    using PlaceOf = std::function<terrain::PartPlace(const terrain::ChunkKey&)>;

    /// `coarse` is the plan of the coarse posts; its level 0 is the database's `base_level`. Pages are read back from the store.
    /// Throws UserError.
    DrapeBaker(const BuildPlan& coarse, std::uint32_t base_level, const DrapeOptions& options, const PartStore& store,
               PlaceOf place_of);

    /// Levels of the coarse lattice from first_level() to end_level() - 1 are to be made in this order.
    [[nodiscard]] std::uint32_t first_level() const { return sampler_.finest_level(); }
    [[nodiscard]] std::uint32_t end_level() const { return coarse_.levels(); }
    [[nodiscard]] std::uint32_t task_count(std::uint32_t level) const;
    /// Returns the page of one chunk, without its place; nothing where the image does not cover it. Any thread.
    [[nodiscard]] std::optional<BakedPage> run(std::uint32_t level, std::uint32_t task);

private:
    void reduce(std::uint32_t level, std::uint32_t i, std::uint32_t j, terrain::DrapePage& page) const;

    const BuildPlan& coarse_;
    const std::uint32_t base_level_;
    DrapeSampler sampler_;
    const PartStore& store_;
    const PlaceOf place_of_;
};

}  // namespace tedavis::host_sim
