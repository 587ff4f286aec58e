/// An aircraft state in cruise over hills with everything valid, and the symbology built from it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/policy/failure_policy.hpp"

namespace tedavis::test_support {

inline constexpr base::Time kSceneNow{1'000'000'000'000};

/// Attitude in degrees; every signal valid at kSceneNow.
[[nodiscard]] flight::AircraftState scene_state(double heading_deg, double pitch_deg, double roll_deg);
/// Terrain ready, phase approach.final by switch.
[[nodiscard]] policy::DisplayConditions scene_conditions();
/// With the whole legend.
[[nodiscard]] draw::SymbologyInput scene_input(const flight::AircraftState& state, std::uint32_t width, std::uint32_t height,
                                               const policy::DisplayConditions& conditions = scene_conditions());

/// The color of a role by day, which painters without a palette have.
[[nodiscard]] inline design::Color day_color(draw::SymbolRole role) { return design::kDaySymbology.color(role); }

/// What is written in a batch, in order, halos left out; glyphs that a clip cut away are missing.
[[nodiscard]] std::string text_of(const draw::QuadBatch& batch);

/// A batch with its memory.
struct BatchStore {
    explicit BatchStore(std::size_t vertices = draw::kSymbologyVertices)
        : vertex_store(vertices),
          index_store(vertices * 3 / 2),
          batch({vertex_store.data(), vertex_store.size()}, {index_store.data(), index_store.size()}) {}
    std::vector<draw::QuadVertex> vertex_store;
    std::vector<std::uint16_t> index_store;
    draw::QuadBatch batch;
};

}  // namespace tedavis::test_support
