#include "render_core/scene/scene.hpp"

#include "render_core/scene/scene_reader.hpp"

namespace tedavis::scene {
namespace {

std::string_view text_of(base::Span<const char> texts, std::uint32_t number) {
    if (texts.size() / kNameBytes <= number) return {};
    return {texts.data() + std::size_t{number} * kNameBytes};
}

const char* remedy(SdbError error) {
    switch (error) {
        case SdbError::unreadable: return "check the medium that holds it";
        case SdbError::not_an_sdb: return "name a file that 'tedavis scene build' wrote";
        case SdbError::wrong_version: return "build it again with 'tedavis scene build'";
        case SdbError::too_large: return "raise the budget line 'scene_data' in the device file, or build it from less";
        default: return "get a whole copy, or build it again with 'tedavis scene build'";
    }
}

/// Beside the file's own arrays: views of its layers and attributes, and what alignment takes.
constexpr std::uint64_t kBesideFile = kMaxLayers * (sizeof(Layer) + 64) + kMaxAttributes * (sizeof(Attribute) + 128);

}  // namespace

std::uint64_t Scene::bytes_needed(std::uint64_t file_bytes) { return file_bytes + kBesideFile; }

const char* to_string(SdbError error) noexcept {
    switch (error) {
        case SdbError::none: return "is sound";
        case SdbError::unreadable: return "cannot be read";
        case SdbError::not_an_sdb: return "is not a scene database";
        case SdbError::wrong_version: return "was written by another version of the scene builder";
        case SdbError::truncated: return "is not as long as its header says";
        case SdbError::damaged: return "is damaged";
        case SdbError::too_large: return "does not fit the memory budget for scenes";
    }
    return "is unknown";
}

base::FaultText describe(const SdbFailure& failure) noexcept {
    return base::fault_text(to_string(failure.error), failure.offset, remedy(failure.error));
}

Attribute Attribute::member(std::uint32_t number) const {
    Attribute one = *this;
    one.values = {members.data() + values.size() * number, values.size()};
    one.members = {};
    return one;
}

ValueState Attribute::state(std::size_t n) const {
    if (values[n] != values[n]) return ValueState::missing;
    return states.empty() ? ValueState::valid : states[n];
}

bool Attribute::states_uncertainty() const {
    return entry->uncertainty_kind != UncertaintyKind::none && (!uncertainties.empty() || entry->uncertainty_all.is_known());
}

Uncertainty Attribute::uncertainty(std::size_t n) const {
    if (state(n) == ValueState::missing) return {};
    return uncertainties.empty() ? entry->uncertainty_all : uncertainties[n];
}

std::string_view Attribute::class_name(std::uint32_t number) const { return text_of(classes, number); }

Run Layer::points_of(std::uint32_t feature) const {
    if (starts.empty()) return {feature, 1};
    return {starts[feature], starts[feature + 1] - starts[feature]};
}

std::string_view Layer::name_of(std::uint32_t feature) const { return text_of(names, feature); }

bool Layer::states_uncertainty() const {
    for (const Attribute& attribute : attributes)
        if (attribute.states_uncertainty()) return true;
    return false;
}

const Attribute* Layer::find(std::string_view attribute) const {
    for (const Attribute& a : attributes)
        if (attribute == a.entry->name) return &a;
    return nullptr;
}

base::Result<Scene, SdbFailure> Scene::load(base::ByteSource& source, base::Arena& arena) {
    Scene scene;
    SceneReader reader(source, arena);
    if (const SdbFailure failure = reader.read(scene.header_, scene.layers_); failure.error != SdbError::none)
        return base::fail(failure);
    return scene;
}

const Layer* Scene::find(std::string_view layer) const {
    for (const Layer& l : layers_)
        if (layer == l.entry->name) return &l;
    return nullptr;
}

}  // namespace tedavis::scene
