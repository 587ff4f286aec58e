#include "host_sim/commands/display_options.hpp"

#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/option_checks.hpp"
#include "host_sim/commands/option_texts.hpp"

namespace tedavis::host_sim {

void add_surface_options(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, GlChoice> kGl = {{"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}};
    command->add_option("--terrain", picture.terrain, "terrain database (.tdb)");
    command->add_option("--scene", picture.scene, "spatial data: scene database (.sdb)");
    command->add_option("--device", picture.device, "device file or shipped name")->capture_default_str();
    command->add_option(
        "--aircraft", picture.aircraft,
        "aircraft file or shipped name: speeds for the airspeed tape and the pilot's eye point; default: none is known");
    command->add_option_function<std::string>(
        "--size", [&picture](const std::string& text) { picture.size = size_from(text); }, "WIDTHxHEIGHT; default: the device's");
    command
        ->add_option_function<std::string>(
            "--gl", [&picture](const std::string& word) { picture.gl = choice_from("--gl", word, kGl); }, "egl or osmesa")
        ->default_str("egl");
}

namespace {

void add_light(CLI::App* command, PictureOptions& picture) {
    command->add_option("--palette", picture.palette,
                        "palette file of the symbology or shipped name: its colors by day and by night; default: standard");
    static const std::map<std::string, design::SymbologyLight> kLight = {{"day", design::SymbologyLight::day},
                                                                         {"night", design::SymbologyLight::night}};
    command
        ->add_option_function<std::string>(
            "--light", [&picture](const std::string& word) { picture.light = choice_from("--light", word, kLight); },
            "day or night: colors of the symbology; terrain, sky and data keep theirs")
        ->default_str("day");
}

/// What stands above the design.
void add_emphasis(CLI::App* command, PictureOptions& picture) {
    add_optional(command, "--tau", picture.tau_px, "terrain error in pixels; default: the design's")->check(above_zero());
    command->add_option_function<std::string>(
        "--weights", [&picture](const std::string& text) { picture.weights = weights_from(text); },
        "of aspects, 0 to 1, such as terrain=0.3,data=1; default: the design's");
    command
        ->add_option("--focus", picture.foci,
                     "a focus before the design's: the keys of [[focus]] within one line of TOML, such as "
                     "'shape = \"circle\", at = \"place\", place = \"DAVOS\", terrain.brightness = 0.5'; may be repeated")
        ->allow_extra_args(false);
}

void add_deadline(CLI::App* command, PictureOptions& picture) {
    add_optional(command, "--deadline", picture.deadline_ms,
                 "milliseconds that a frame may take by the costs of --costs; default: none is held")
        ->check(above_zero());
    command->add_option(
        "--costs", picture.costs,
        "what everything costs on this machine, and the quality levels to choose from: a file that calibrate wrote");
}

/// Views of what the eye makes of a picture.
void add_perception(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, design::SaliencyView> kSaliency = {{"heat", design::SaliencyView::heat},
                                                                          {"map", design::SaliencyView::map}};
    command->add_option_function<std::string>(
        "--saliency", [&picture](const std::string& word) { picture.saliency = choice_from("--saliency", word, kSaliency); },
        "what draws the eye in each picture: heat (over it) or map (alone); default: as the design says");
    static const std::map<std::string, design::ClutterView> kClutter = {{"edges", design::ClutterView::edges},
                                                                        {"regions", design::ClutterView::regions}};
    command->add_option_function<std::string>(
        "--clutter", [&picture](const std::string& word) { picture.clutter = choice_from("--clutter", word, kClutter); },
        "edges of each picture (alone), or regions (how dense they are, over it); default: as the design says");
}

}  // namespace

void add_picture_options(CLI::App* command, PictureOptions& picture) {
    add_surface_options(command, picture);
    command->add_option("--design", picture.design, "design file or shipped name")->capture_default_str();
    add_light(command, picture);
    add_emphasis(command, picture);
    add_deadline(command, picture);
    add_perception(command, picture);
    command->add_flag("--force-effects", picture.force_effects, "leave no effect out for being too small to be seen");
}

void add_legend(CLI::App* command, PictureOptions& picture) {
    static const std::map<std::string, flight::LegendShow> kLegends = {
        {"none", flight::LegendShow::none}, {"key", flight::LegendShow::key}, {"whole", flight::LegendShow::whole}};
    command
        ->add_option_function<std::string>(
            "--legend", [&picture](const std::string& word) { picture.legend = choice_from("--legend", word, kLegends); },
            "none, key (a small key of the scales that are shown) or whole; a switch or the bus may ask for another")
        ->default_str("key");
}

void add_accuracy_shown(CLI::App* command, AccuracyShown& shown) {
    command->add_flag("--show-accuracy", shown.figures,
                      "writes over each picture its requested and its proven terrain error and its quality level");
    command->add_flag("--error-map", shown.error_map,
                      "colors the ground by its measured error on the screen, dark blue at 0 to yellow at the requested error");
}

void add_time(CLI::App* command, std::optional<base::Time>& time) {
    command->add_option_function<std::string>(
        "--time", [&time](const std::string& text) { time = time_from(text); },
        "UTC such as 2026-06-01T14:00:00Z, by which data are valid and have an age; default: data at their own first time");
}

}  // namespace tedavis::host_sim
