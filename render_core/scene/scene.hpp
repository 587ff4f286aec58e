/// A scene database in memory: layers of spatial data with their attributes and uncertainties.
///
/// Memory    all from the arena passed to load(); nothing is read or allocated later.
/// Failure   load() verifies every checksum, size, count and range; accepted data need no further checks. On failure the arena
///           may be partly used: reset it.
/// Thread    const after load().
#pragma once

#include <string_view>

#include "render_core/base/fault_text.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/result.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::scene {

enum class SdbError : std::uint8_t { none, unreadable, not_an_sdb, wrong_version, truncated, damaged, too_large };
/// Returns the predicate of a message: "is not a scene database".
[[nodiscard]] const char* to_string(SdbError error) noexcept;

struct SdbFailure {
    SdbError error = SdbError::none;
    std::uint64_t offset = 0;
};

/// Returns what is wrong, where, and what to do, to be appended to the file's name.
[[nodiscard]] base::FaultText describe(const SdbFailure& failure) noexcept;

/// An attribute of a layer, with one value per feature or per point.
struct Attribute {
    const AttributeEntry* entry = nullptr;
    base::Span<const float> values;
    base::Span<const Uncertainty> uncertainties;  ///< empty: all have the same uncertainty
    base::Span<const ValueState> states;          ///< empty: all values that are not missing are valid
    base::Span<const char> classes;
    base::Span<const float> members;

    [[nodiscard]] std::uint32_t member_count() const { return entry->member_count; }
    /// Returns one member of an ensemble, 0 .. member_count() - 1: its values, with the states and uncertainties of the mean.
    [[nodiscard]] Attribute member(std::uint32_t number) const;
    [[nodiscard]] ValueState state(std::size_t n) const;
    /// True where the data state an uncertainty for any value; otherwise none may be shown, and the values must not look
    /// certain.
    [[nodiscard]] bool states_uncertainty() const;
    /// Returns the stated uncertainty, without the effect of age. Unknown where the value is missing.
    [[nodiscard]] Uncertainty uncertainty(std::size_t n) const;
    [[nodiscard]] std::string_view class_name(std::uint32_t number) const;
};

struct Run {
    std::uint32_t first = 0, count = 0;
};

struct Layer {
    const LayerEntry* entry = nullptr;
    base::Span<const ScenePoint> points;
    base::Span<const std::uint32_t> starts;
    base::Span<const float> levels_m;
    base::Span<const std::int64_t> times_ns;
    base::Span<const char> names;
    base::Span<const ModelVertex> vertices;
    base::Span<const std::uint16_t> triangles;
    base::Span<const Attribute> attributes;

    [[nodiscard]] Run points_of(std::uint32_t feature) const;
    [[nodiscard]] std::string_view name_of(std::uint32_t feature) const;  ///< empty where the feature has no name
    [[nodiscard]] const Attribute* find(std::string_view attribute) const;
    /// True where any attribute does.
    [[nodiscard]] bool states_uncertainty() const;
};

class Scene {
public:
    [[nodiscard]] static base::Result<Scene, SdbFailure> load(base::ByteSource& source, base::Arena& arena);

    /// Bytes of an arena that surely hold a file of so many bytes.
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint64_t file_bytes);

    [[nodiscard]] const SceneHeader& header() const { return header_; }
    [[nodiscard]] base::Span<const Layer> layers() const { return layers_; }
    [[nodiscard]] const Layer* find(std::string_view layer) const;

private:
    SceneHeader header_{};
    base::Span<const Layer> layers_;
};

}  // namespace tedavis::scene
