#include "render_core/scene/scene_reader.hpp"

#include <cstddef>
#include <cstring>

#include "render_core/base/hash.hpp"
#include "render_core/scene/scene_rules.hpp"

namespace tedavis::scene {
namespace {

bool header_holds(const SceneHeader& h) {
    return base::crc32(&h, offsetof(SceneHeader, header_crc)) == h.header_crc && h.header_bytes == sizeof h && ends(h.name) &&
           ends(h.origin) && h.layer_count <= kMaxLayers && h.attribute_count <= kMaxAttributes;
}

bool lies_inside(std::uint64_t offset, std::uint64_t bytes, std::uint64_t file_bytes) {
    return offset >= sizeof(SceneHeader) && offset <= file_bytes && bytes <= file_bytes - offset;
}

bool has_twin(base::Span<const LayerEntry> layers, std::size_t n) {
    for (std::size_t other = 0; other < n; ++other)
        if (std::strcmp(layers[other].name, layers[n].name) == 0) return true;
    return false;
}

}  // namespace

SdbFailure SceneReader::read(SceneHeader& header, base::Span<const Layer>& layers) {
    if (const SdbFailure failure = read_header(header); failure.error != SdbError::none) return failure;
    if (const SdbFailure failure = read_tables(header); failure.error != SdbError::none) return failure;
    const base::Span<Layer> read_ones = arena_.allocate_array<Layer>(header.layer_count);
    if (read_ones.size() != header.layer_count) return {SdbError::too_large, 0};
    for (std::size_t n = 0; n < read_ones.size(); ++n) {
        const std::uint64_t offset = header.table_offset + n * sizeof(LayerEntry);
        if (!entry_holds(layer_entries_[n], header.attribute_count) || has_twin(layer_entries_, n)) return damaged(offset);
        read_ones[n] = {};
        if (const SdbFailure failure = read_layer(layer_entries_[n], read_ones[n]); failure.error != SdbError::none)
            return failure.offset != 0 ? failure : SdbFailure{failure.error, offset};
    }
    layers = read_ones;
    return {};
}

SdbFailure SceneReader::read_header(SceneHeader& header) {
    if (source_.size() < sizeof header) return {SdbError::not_an_sdb, 0};
    if (!source_.read(0, &header, sizeof header)) return {SdbError::unreadable, 0};
    if (std::memcmp(header.magic, kSdbMagic, sizeof kSdbMagic) != 0) return {SdbError::not_an_sdb, 0};
    if (header.version != kSdbVersion) return {SdbError::wrong_version, offsetof(SceneHeader, version)};
    if (!header_holds(header)) return damaged(0);
    if (source_.size() != header.file_bytes) return {SdbError::truncated, source_.size()};
    file_bytes_ = header.file_bytes;
    return {};
}

SdbFailure SceneReader::read_tables(const SceneHeader& header) {
    const std::size_t layer_bytes = header.layer_count * sizeof(LayerEntry),
                      attribute_bytes = header.attribute_count * sizeof(AttributeEntry);
    if (!lies_inside(header.table_offset, layer_bytes + attribute_bytes, file_bytes_)) return damaged(header.table_offset);
    layer_entries_ = arena_.allocate_array<LayerEntry>(header.layer_count);
    attribute_entries_ = arena_.allocate_array<AttributeEntry>(header.attribute_count);
    if (layer_entries_.size() != header.layer_count || attribute_entries_.size() != header.attribute_count)
        return {SdbError::too_large, header.table_offset};
    if (!source_.read(header.table_offset, layer_entries_.data(), layer_bytes) ||
        !source_.read(header.table_offset + layer_bytes, attribute_entries_.data(), attribute_bytes))
        return {SdbError::unreadable, header.table_offset};
    const std::uint32_t crc =
        base::crc32(attribute_entries_.data(), attribute_bytes, base::crc32(layer_entries_.data(), layer_bytes));
    return crc == header.table_crc ? SdbFailure{} : damaged(header.table_offset);
}

template <class T>
SdbFailure SceneReader::read_part(const ScenePart& part, std::uint64_t count, bool may_be_left_out, base::Span<const T>& values) {
    if (part.bytes == 0 && (count == 0 || may_be_left_out)) return {};
    if (count > file_bytes_ / sizeof(T) || part.bytes != count * sizeof(T) || !lies_inside(part.offset, part.bytes, file_bytes_))
        return damaged(part.offset);
    const base::Span<T> read_ones = arena_.allocate_array<T>(static_cast<std::size_t>(count));
    if (read_ones.size() != count) return {SdbError::too_large, part.offset};
    if (!source_.read(part.offset, read_ones.data(), static_cast<std::size_t>(part.bytes)))
        return {SdbError::unreadable, part.offset};
    if (base::crc32(read_ones.data(), static_cast<std::size_t>(part.bytes)) != part.crc) return damaged(part.offset);
    values = read_ones;
    return {};
}

SdbFailure SceneReader::read_layer(const LayerEntry& entry, Layer& layer) {
    layer.entry = &entry;
    const bool is_grid = entry.shape == LayerShape::grid,
               has_runs = entry.shape == LayerShape::lines || entry.shape == LayerShape::areas,
               is_mesh = entry.shape == LayerShape::meshes;
    const SdbFailure failures[] = {
        read_part(entry.points, is_grid ? 0 : entry.point_count, false, layer.points),
        read_part(entry.starts, has_runs ? entry.feature_count + 1u : 0, false, layer.starts),
        read_part(entry.levels, is_grid ? entry.grid.levels : 0, is_grid && entry.grid.levels == 1, layer.levels_m),
        read_part(entry.times, is_grid ? entry.grid.times : 0, is_grid && entry.grid.times == 1, layer.times_ns),
        read_part(entry.names, is_grid ? 0 : std::uint64_t{entry.feature_count} * kNameBytes, true, layer.names),
        read_part(entry.vertices, is_mesh ? entry.vertex_count : 0, false, layer.vertices),
        read_part(entry.triangles, is_mesh ? std::uint64_t{entry.triangle_count} * 3 : 0, false, layer.triangles),
    };
    for (const SdbFailure& failure : failures)
        if (failure.error != SdbError::none) return failure;
    if (!points_hold(layer.points)) return damaged(entry.points.offset);
    if (has_runs && !starts_hold(layer.starts, entry.point_count, least_points(entry.shape))) return damaged(entry.starts.offset);
    if (!levels_hold(layer.levels_m)) return damaged(entry.levels.offset);
    if (!times_hold(layer.times_ns)) return damaged(entry.times.offset);
    if (!names_hold(layer.names)) return damaged(entry.names.offset);
    if (!model_holds(layer.vertices, layer.triangles)) return damaged(entry.vertices.offset);
    return read_attributes(entry, layer);
}

SdbFailure SceneReader::read_attributes(const LayerEntry& entry, Layer& layer) {
    const base::Span<Attribute> read_ones = arena_.allocate_array<Attribute>(entry.attribute_count);
    if (read_ones.size() != entry.attribute_count) return {SdbError::too_large, 0};
    for (std::uint32_t n = 0; n < entry.attribute_count; ++n) {
        const AttributeEntry& attribute = attribute_entries_[entry.first_attribute + n];
        if (!entry_holds(attribute, entry)) return damaged(0);
        read_ones[n] = {};
        if (const SdbFailure failure = read_attribute(attribute, read_ones[n]); failure.error != SdbError::none) return failure;
    }
    layer.attributes = read_ones;
    return {};
}

SdbFailure SceneReader::read_attribute(const AttributeEntry& entry, Attribute& attribute) {
    attribute.entry = &entry;
    const SdbFailure failures[] = {
        read_part(entry.values, entry.value_count, false, attribute.values),
        read_part(entry.uncertainties, entry.value_count, true, attribute.uncertainties),
        read_part(entry.states, entry.value_count, true, attribute.states),
        read_part(entry.classes, std::uint64_t{entry.class_count} * kNameBytes, true, attribute.classes),
        read_part(entry.members, entry.value_count * entry.member_count, false, attribute.members),
    };
    for (const SdbFailure& failure : failures)
        if (failure.error != SdbError::none) return failure;
    if (!values_hold(attribute.values, entry)) return damaged(entry.values.offset);
    if (!values_hold(attribute.members, entry)) return damaged(entry.members.offset);
    if (!states_hold(attribute.states)) return damaged(entry.states.offset);
    return names_hold(attribute.classes) ? SdbFailure{} : damaged(entry.classes.offset);
}

}  // namespace tedavis::scene
