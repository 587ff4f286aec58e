#include "host_sim/scene_builder/sdb_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {
namespace {

using scene::AttributeEntry;
using scene::LayerEntry;
using scene::ScenePart;

constexpr std::size_t kAlignment = 8;

template <std::size_t N>
void set_text(char (&field)[N], const std::string& text, const std::string& owner, const char* what) {
    if (text.size() >= N)
        throw UserError(owner + ": " + what + " '" + text + "' is longer than " + std::to_string(N - 1) + " bytes; shorten it");
    std::memcpy(field, text.data(), text.size());
}

class SdbWriter {
public:
    explicit SdbWriter(const SceneDraft& draft) : draft_(draft) {}

    std::vector<std::uint8_t> write() {
        if (draft_.layers.size() > scene::kMaxLayers)
            throw UserError("a scene has at most " + std::to_string(scene::kMaxLayers) + " layers, this one has " +
                            std::to_string(draft_.layers.size()) + "; leave some out");
        bytes_.resize(sizeof(scene::SceneHeader) + table_bytes());
        for (const LayerDraft& layer : draft_.layers) add(layer);
        write_tables();
        return std::move(bytes_);
    }

private:
    [[nodiscard]] std::size_t attribute_count() const {
        std::size_t count = 0;
        for (const LayerDraft& layer : draft_.layers) count += layer.attributes.size();
        return count;
    }
    [[nodiscard]] std::size_t table_bytes() const {
        return draft_.layers.size() * sizeof(LayerEntry) + attribute_count() * sizeof(AttributeEntry);
    }

    template <class T>
    ScenePart part(const std::vector<T>& values) {
        if (values.empty()) return {};
        bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
        const std::size_t offset = bytes_.size(), count = values.size() * sizeof(T);
        bytes_.resize(offset + count);
        std::memcpy(&bytes_[offset], values.data(), count);
        return {offset, count, base::crc32(&bytes_[offset], count), 0};
    }
    ScenePart names_part(const std::vector<std::string>& names) {
        std::vector<char> texts(names.size() * scene::kNameBytes, 0);
        for (std::size_t n = 0; n < names.size(); ++n)
            names[n].copy(&texts[n * scene::kNameBytes], whole_characters(names[n], scene::kNameBytes - 1));
        return part(texts);
    }
    /// Bytes of a name that is cut, if it must be, between characters of UTF-8.
    static std::size_t whole_characters(const std::string& text, std::size_t most) {
        if (text.size() <= most) return text.size();
        while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0u) == 0x80u) --most;
        return most;
    }

    void add(const LayerDraft& layer) {
        LayerEntry entry{};
        set_text(entry.name, layer.name, layer.name, "its name");
        set_text(entry.title, layer.title, layer.name, "its title");
        set_text(entry.source, layer.source, layer.name, "its source");
        entry.shape = layer.shape;
        entry.role = layer.role;
        entry.height_datum = layer.height_datum;
        entry.importance = layer.importance;
        entry.first_attribute = static_cast<std::uint32_t>(attributes_.size());
        entry.attribute_count = static_cast<std::uint32_t>(layer.attributes.size());
        entry.feature_count = static_cast<std::uint32_t>(layer.feature_count());
        entry.point_count = static_cast<std::uint32_t>(layer.point_count());
        entry.data_time_ns = layer.data_time_ns;
        entry.valid_from_ns = layer.valid_from_ns;
        entry.valid_until_ns = layer.valid_until_ns;
        entry.position_accuracy_m = static_cast<float>(layer.position_accuracy_m);
        entry.height_accuracy_m = static_cast<float>(layer.height_accuracy_m);
        entry.grid = layer.grid;
        add_parts(layer, entry);
        layers_.push_back(entry);
        for (const AttributeDraft& attribute : layer.attributes) add(attribute, layer);
    }
    void add_parts(const LayerDraft& layer, LayerEntry& entry) {
        entry.points = part(layer.points);
        entry.starts = part(layer.starts);
        entry.levels = part(layer.levels_m);
        entry.times = part(layer.times_ns);
        entry.names = names_part(layer.names);
        entry.vertices = part(layer.model.vertices);
        entry.triangles = part(layer.model.triangles);
        entry.vertex_count = static_cast<std::uint32_t>(layer.model.vertices.size());
        entry.triangle_count = static_cast<std::uint32_t>(layer.model.triangles.size());
    }

    void add(const AttributeDraft& attribute, const LayerDraft& layer) {
        if (attributes_.size() == scene::kMaxAttributes)
            throw UserError(layer.name + ": a scene has at most " + std::to_string(scene::kMaxAttributes) +
                            " attributes; leave some out");
        if (attribute.classes.size() > scene::kMaxClasses)
            throw UserError(layer.name + ": attribute '" + attribute.name + "' has " + std::to_string(attribute.classes.size()) +
                            " classes, at most " + std::to_string(scene::kMaxClasses) + " are possible; join some");
        AttributeEntry entry{};
        set_text(entry.name, attribute.name, layer.name, "the attribute's name");
        set_text(entry.title, attribute.title, layer.name, "the attribute's title");
        set_text(entry.unit, attribute.unit, layer.name, "the attribute's unit");
        entry.scale = attribute.scale;
        entry.of = attribute.of;
        entry.uncertainty_kind = attribute.uncertainty_kind;
        entry.uncertainty_scope = attribute.uncertainty_scope;
        entry.class_count = static_cast<std::uint32_t>(attribute.classes.size());
        set_limits(attribute, entry);
        entry.uncertainty_full = static_cast<float>(attribute.uncertainty_full);
        entry.uncertainty_growth_per_hour = static_cast<float>(attribute.uncertainty_growth_per_hour);
        entry.uncertainty_all = attribute.uncertainty_all;
        entry.value_count = attribute.values.size();
        entry.values = part(attribute.values);
        entry.uncertainties = part(attribute.uncertainties);
        entry.states = part(attribute.states);
        entry.classes = names_part(attribute.classes);
        entry.members = part(joined(attribute.members));
        entry.member_count = static_cast<std::uint8_t>(attribute.members.size());
        set_origin(attribute, entry);
        attributes_.push_back(entry);
    }
    void set_origin(const AttributeDraft& attribute, AttributeEntry& entry) const {
        if (attribute.derived_from.empty()) return;
        for (std::size_t n = 0; n < draft_.layers.size(); ++n)
            if (draft_.layers[n].name == attribute.derived_from) entry.derived_from = static_cast<std::uint8_t>(n + 1);
        constexpr std::int64_t kMinute_ns = 60'000'000'000;
        const std::int64_t minute = attribute.derived_time_ns.value_or(0) / kMinute_ns;
        entry.derived_minute = static_cast<std::uint32_t>(std::clamp<std::int64_t>(minute, 0, UINT32_MAX));
    }
    static std::vector<float> joined(const std::vector<std::vector<float>>& members) {
        std::vector<float> all;
        for (const std::vector<float>& member : members) all.insert(all.end(), member.begin(), member.end());
        return all;
    }
    static void set_limits(const AttributeDraft& attribute, AttributeEntry& entry) {
        bool any = false;
        const auto include = [&](const std::vector<float>& values) {
            for (const float value : values) {
                if (std::isnan(value)) continue;
                entry.minimum = any ? std::min(entry.minimum, value) : value;
                entry.maximum = any ? std::max(entry.maximum, value) : value;
                any = true;
            }
        };
        include(attribute.values);
        for (const std::vector<float>& member : attribute.members) include(member);
    }

    void write_tables() {
        scene::SceneHeader header{};
        std::memcpy(header.magic, scene::kSdbMagic, sizeof header.magic);
        header.version = scene::kSdbVersion;
        header.header_bytes = sizeof header;
        header.revision = draft_.revision;
        header.file_bytes = bytes_.size();
        header.table_offset = sizeof header;
        header.layer_count = static_cast<std::uint32_t>(layers_.size());
        header.attribute_count = static_cast<std::uint32_t>(attributes_.size());
        set_text(header.name, draft_.name, "the scene", "its name");
        set_text(header.origin, draft_.origin, "the scene", "its origin");
        std::uint8_t* const table = bytes_.data() + sizeof header;
        const std::size_t layer_bytes = layers_.size() * sizeof(LayerEntry);
        if (!layers_.empty()) std::memcpy(table, layers_.data(), layer_bytes);
        if (!attributes_.empty())
            std::memcpy(table + layer_bytes, attributes_.data(), attributes_.size() * sizeof(AttributeEntry));
        header.table_crc = base::crc32(table, table_bytes());
        header.header_crc = base::crc32(&header, offsetof(scene::SceneHeader, header_crc));
        std::memcpy(bytes_.data(), &header, sizeof header);
    }

    const SceneDraft& draft_;
    std::vector<std::uint8_t> bytes_;
    std::vector<LayerEntry> layers_;
    std::vector<AttributeEntry> attributes_;
};

}  // namespace

std::vector<std::uint8_t> sdb_bytes(const SceneDraft& draft) { return SdbWriter(draft).write(); }

}  // namespace tedavis::host_sim
