#include "host_sim/scene_builder/scene_build.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/area_raster.hpp"
#include "host_sim/scene_builder/derived_attribute.hpp"
#include "host_sim/scene_builder/feature_layer.hpp"
#include "host_sim/scene_builder/feature_source.hpp"
#include "host_sim/scene_builder/grid_layer.hpp"
#include "host_sim/scene_builder/model_source.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/role_needs.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/scene_builder/source_kind.hpp"
#include "host_sim/scene_builder/source_path.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

void require_no_words_for_features(const LayerRecipe& recipe) {
    const char* word = nullptr;
    if (!recipe.aircraft.empty()) word = "aircraft";
    if (recipe.name_variable != LayerRecipe().name_variable) word = "name_variable";
    if (!recipe.time_variable.empty()) word = "time_variable";
    if (!recipe.prepare.keep_attribute.empty()) word = "keep_attribute";
    if (!recipe.wind_layer.empty()) word = "wind_layer";
    if (!recipe.model.empty()) word = "model";
    if (recipe.raster_m > 0) word = "raster_m";
    for (const AttributeRecipe& attribute : recipe.attributes)
        if (!attribute.uncertainty.classes.empty()) word = "uncertainty.classes";
    if (word != nullptr)
        throw UserError(recipe.name + ": '" + word + "' is for tables and flights, and " + recipe.source +
                        " is a grid; leave it out (an attribute's 'least' and 'most' choose values of a grid)");
}

/// Of data of an unknown time nobody knows how far their uncertainty has grown.
void require_time_of_growth(const LayerRecipe& recipe, const LayerDraft& layer) {
    if (layer.data_time_ns != scene::kNoTime || !layer.times_ns.empty()) return;
    for (const AttributeDraft& attribute : layer.attributes)
        if (attribute.uncertainty_growth_per_hour > 0)
            throw UserError(recipe.name + ": 'growth_per_hour' of '" + attribute.name + "' counts from the data's time, and " +
                            recipe.source + " states none; give it as data_time");
}

/// What the recipe says of the layer as a whole, whatever its source.
void finish(const LayerRecipe& recipe, LayerDraft& layer) {
    layer.source = std::filesystem::path(recipe.source).filename().string();
    if (!recipe.licence.empty()) layer.source += ", " + recipe.licence;
    layer.role = recipe.role;
    layer.importance = recipe.importance;
    layer.position_accuracy_m = recipe.position_accuracy_m;
    layer.height_accuracy_m = recipe.height_accuracy_m;
    if (recipe.height_datum) layer.height_datum = *recipe.height_datum;
    require_time_of_growth(recipe, layer);
    if (!(recipe.valid_hours > 0) || layer.valid_until_ns != INT64_MAX) return;
    if (layer.data_time_ns == scene::kNoTime)
        throw UserError(recipe.name + ": 'valid_hours' counts from the data's time, and " + recipe.source +
                        " states none; give it as data_time");
    layer.valid_until_ns =
        layer.data_time_ns + static_cast<std::int64_t>(recipe.valid_hours * static_cast<double>(base::kNanosecondsPerHour));
}

void set_model(const LayerRecipe& recipe, const std::string& folder, LayerDraft& layer) {
    if (layer.shape != scene::LayerShape::points)
        throw UserError(recipe.name + ": 'model' stands at points, and the role shows " + std::string(shape_name(layer.shape)) +
                        "; leave it out or give role = \"model\"");
    layer.model = read_model(source_path(folder, recipe.model));
    layer.shape = scene::LayerShape::meshes;
}

LayerDraft make_layer(const LayerRecipe& recipe, const std::string& folder, std::vector<std::string>& notes) {
    const std::string path = source_path(folder, recipe.source);
    const SourceKind kind = source_kind(path, recipe.role);
    require_what_role_needs(recipe, kind);
    if (kind == SourceKind::grid) {
        require_no_words_for_features(recipe);
        GridLayer made = make_grid_layer(without_derived(recipe), folder);
        notes.insert(notes.end(), made.notes.begin(), made.notes.end());
        return std::move(made.draft);
    }
    FeatureSource source = read_feature_source(kind, recipe, path);
    LayerRecipe bound = without_derived(recipe);
    if (recipe.attributes.empty()) bound.attributes = std::move(source.usual_attributes);
    FeatureLayer made = make_feature_layer(bound, std::move(source.features));
    notes.insert(notes.end(), made.notes.begin(), made.notes.end());
    if (!recipe.model.empty()) set_model(recipe, folder, made.draft);
    if (recipe.raster_m > 0) made.draft = rasterized(made.draft, recipe.raster_m, recipe.prepare.region);
    return std::move(made.draft);
}

void require_unique_names(const SceneRecipe& recipe) {
    std::set<std::string> layers;
    for (const LayerRecipe& layer : recipe.layers) {
        if (!layers.insert(layer.name).second) throw UserError(layer.name + ": two layers have this name; give each its own");
        std::set<std::string> attributes;
        for (const AttributeRecipe& attribute : layer.attributes)
            if (!attributes.insert(attribute.name).second)
                throw UserError(layer.name + ": two attributes have the name '" + attribute.name + "'; give each its own");
    }
}

std::vector<std::string> inputs_of(const SceneRecipe& recipe, const std::string& folder) {
    std::vector<std::string> inputs;
    for (const LayerRecipe& layer : recipe.layers) {
        inputs.push_back(source_path(folder, layer.source));
        if (!layer.model.empty()) inputs.push_back(source_path(folder, layer.model));
        for (const AttributeRecipe& attribute : layer.attributes)
            if (!attribute.uncertainty.source.empty()) inputs.push_back(source_path(folder, attribute.uncertainty.source));
    }
    return inputs;
}

/// Of a database that is damaged nobody knows it.
std::uint64_t next_revision(const std::string& output) {
    std::error_code not_there;
    if (!std::filesystem::is_regular_file(output, not_there)) return 1;
    try {
        return OpenScene(output).scene().header().revision + 1;
    } catch (const UserError&) {
        return 1;
    }
}

/// Out of the layers the one of that name, where there is one.
std::optional<LayerDraft> take(std::vector<LayerDraft>& layers, const std::string& name) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const LayerDraft& layer) { return layer.name == name; });
    if (found == layers.end()) return std::nullopt;
    LayerDraft taken = std::move(*found);
    layers.erase(found);
    return taken;
}

}  // namespace

MadeScene make_scene(const SceneRecipe& recipe, const std::string& folder, const SceneProgress& progress,
                     std::vector<LayerDraft> given) {
    require_unique_names(recipe);
    MadeScene made;
    made.draft.name = recipe.name;
    made.draft.origin = recipe.origin;
    std::set<std::string> standing_in;
    for (const LayerRecipe& layer : recipe.layers) {
        progress(layer.name, made.draft.layers.size(), recipe.layers.size());
        if (std::optional<LayerDraft> other = take(given, layer.name)) {
            standing_in.insert(layer.name);
            made.draft.layers.push_back(std::move(*other));
            continue;
        }
        made.draft.layers.push_back(make_layer(layer, folder, made.notes));
        finish(layer, made.draft.layers.back());
    }
    for (LayerDraft& layer : given) made.draft.layers.push_back(std::move(layer));
    // Of all layers: a wind may stand behind the lines that ask for it.
    for (std::size_t n = 0; n < recipe.layers.size(); ++n) {
        if (standing_in.count(recipe.layers[n].name) > 0) continue;
        const std::vector<std::string> notes = add_derived(recipe.layers[n], made.draft.layers[n], made.draft.layers);
        made.notes.insert(made.notes.end(), notes.begin(), notes.end());
    }
    return made;
}

std::vector<std::string> build_scene(const std::string& scene_file, const std::string& output, const SceneProgress& progress) {
    const SceneRecipe recipe = parse_scene(read_file(scene_file), scene_file);
    const std::string folder = std::filesystem::path(scene_file).parent_path().string();
    std::vector<std::string> inputs = inputs_of(recipe, folder);
    inputs.push_back(scene_file);
    require_other_file(output, inputs);
    require_replaceable(output, {scene::kSdbMagic, sizeof scene::kSdbMagic}, "scene database");
    MadeScene made = make_scene(recipe, folder, progress);
    made.draft.revision = next_revision(output);
    const std::vector<std::uint8_t> bytes = sdb_bytes(made.draft);
    AtomicFile file(output);
    file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.seal();
    (void)OpenScene(file.part_path());  // what the board would refuse is not put in its place
    file.commit();
    return made.notes;
}

}  // namespace tedavis::host_sim
