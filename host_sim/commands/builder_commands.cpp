#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/option_checks.hpp"

namespace tedavis::host_sim {
namespace {

void add_convert(CLI::App& app, CommandLine& line) {
    ConvertOptions& o = line.convert;
    CLI::App* command = add_long_command(app, line, "convert",
                                         "recorded flight (IGC, GPX, ADS-B JSON, CSV) to a candump log of CANaerospace frames",
                                         [&o](Console& console) { return run_convert(o, console); });
    command->add_option("FLIGHT", o.flight, "the recording; may be gzip-compressed")->required();
    command->add_option("-o", o.output, "the log to write")->required();
    add_flight_options(command, o);
}

void add_scenario(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("scenario", "generated flights");
    group->require_subcommand(1);
    ScenarioBuildOptions& o = line.scenario;
    CLI::App* command =
        add_long_command(*group, line, "build", "scenario file to flight.log, flight.switches, scene.sdb and scenario.json",
                         [&o](Console& console) { return run_scenario_build(o, console); });
    command->add_option("SCENARIO", o.scenario, "scenario file or shipped name")->required();
    command->add_option("-o", o.output, "folder to write to")->required();
    add_optional(command, "--seed", o.seed, "replaces the file's seed")->check(from_zero());
}

void add_scene(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("scene", "scene databases: spatial data and their uncertainty");
    group->require_subcommand(1);
    SceneBuildOptions& b = line.scene_build;
    CLI::App* build = add_long_command(*group, line, "build", "scene file and its sources to a database",
                                       [&b](Console& console) { return run_scene_build(b, console); });
    build->add_option("SCENE", b.scene, "scene file or shipped name")->required();
    build->add_option("-o", b.output, "the database to write (.sdb)")->required();
    SceneInfoOptions& i = line.scene_info;
    CLI::App* info =
        add_command(*group, line, "info", "what a database holds", [&i](Console& console) { return run_scene_info(i, console); });
    info->add_option("DATABASE", i.database, "database (.sdb)")->required();
    SceneLookOptions& l = line.scene_look;
    CLI::App* look = add_command(*group, line, "look", "what a source holds, and a layer for a scene file to begin with",
                                 [&l](Console& console) { return run_scene_look(l, console); });
    look->add_option("FILE", l.files, "grids, tables, maps, obstacles, runways, airspaces, recorded flights")->required();
    look->add_option("--crs", l.crs, "coordinate system of files that do not state it, such as EPSG:2056");
}

void add_terrain(CLI::App& app, CommandLine& line) {
    CLI::App* group = app.add_subcommand("terrain", "terrain databases");
    group->require_subcommand(1);
    TerrainBuildOptions& b = line.terrain_build;
    CLI::App* build = add_long_command(*group, line, "build", "rasters to a database with error proof",
                                       [&b](Console& console) { return run_terrain_build(b, console); });
    build->add_option("DEM", b.rasters, "any raster that GDAL reads")->required();
    build->add_option("-o", b.output, "the database to write (.tdb)")->required();
    add_raster_options(build, b);
    TerrainCheckOptions& c = line.terrain_check;
    CLI::App* check = add_long_command(*group, line, "check", "every chunk against the rasters again",
                                       [&c](Console& console) { return run_terrain_check(c, console); });
    check->add_option("DATABASE", c.database, "database (.tdb)")->required();
    check->add_option("DEM", c.build.rasters, "the rasters it was built from")->required();
    add_raster_options(check, c.build);
    TerrainInfoOptions& i = line.terrain_info;
    CLI::App* info = add_command(*group, line, "info", "what a database holds",
                                 [&i](Console& console) { return run_terrain_info(i, console); });
    info->add_option("DATABASE", i.database, "database (.tdb)")->required();
    TerrainFractalOptions& f = line.terrain_fractal;
    CLI::App* fractal = add_long_command(*group, line, "fractal", "generated terrain, a square of any size",
                                         [&f](Console& console) { return run_terrain_fractal(f, console); });
    fractal->add_option("--size", f.size, "posts a side")->check(from_zero())->capture_default_str();
    fractal->add_option("--seed", f.seed, "equal seeds give equal terrain")->check(from_zero())->capture_default_str();
    fractal->add_option("--type", f.numbers, "float32, or int16: whole metres in half the space")
        ->check(CLI::IsMember({"float32", "int16"}))
        ->capture_default_str();
    fractal->add_option("-o", f.output, "the raster to write (.tif)")->required();
    TerrainCacheOptions& k = line.terrain_cache;
    CLI::App* cache = add_command(*group, line, "cache", "the databases that fly has built and kept",
                                  [&k](Console& console) { return run_terrain_cache(k, console); });
    cache->add_flag("--clear", k.clear, "removes them; fly builds anew what it needs");
}

void add_pack(CLI::App& app, CommandLine& line) {
    PackOptions& o = line.pack;
    CLI::App* command = add_long_command(app, line, "pack", "one folder, hashed and dated, that desk and board both start from",
                                         [&o](Console& console) { return run_pack(o, console); });
    command->add_option("CONFIG", o.config, "configuration: a board file, or what replay --save-config wrote")->required();
    command->add_option("-o", o.output, "folder to write: the pack")->required();
    command->add_flag("--replace", o.replaces, "replaces an earlier pack at that place, in one step");
    command->add_option("--valid-from", o.valid_from, "first UTC day on which the data may be used, such as 2026-12-01");
    command->add_option("--valid-until", o.valid_until, "last such day");
    command->add_option("--sign", o.sign, "secret key of minisign: signs the pack's manifest");
}

}  // namespace

void add_flight_options(CLI::App* command, ConvertOptions& o) {
    command->add_option("--aircraft", o.aircraft, "identity or callsign where the file holds several");
    add_optional(
        command, "--qnh", o.qnh_hpa,
        "QNH in hPa: pressure altitudes become altitudes on that setting; no geometric heights without --assume-geometric");
    command->add_flag(
        "--assume-geometric", o.assume_geometric,
        "without GNSS heights, take barometric altitudes for heights above sea level: with --qnh those on that setting, "
        "else pressure altitudes as they are");
}

void add_raster_options(CLI::App* command, TerrainBuildOptions& o) {
    command->add_option("--crs", o.crs,
                        "coordinate system of the rasters where they do not state it, such as EPSG:4326; with a vertical part "
                        "(EPSG:4326+5773, EPSG:4979) also what heights are above");
    command->add_option("--extent", o.extent,
                        "W,S,E,N: outer edges of a raster that does not say where it lies, in units of --crs, else in degrees");
    command->add_option("--bounds", o.bounds, "W,S,E,N in degrees: leaves out what lies outside");
    command->add_option("--vertical-datum", o.vertical_datum, "egm96 or ellipsoid; default: what the rasters state, else egm96")
        ->check(CLI::IsMember({"egm96", "ellipsoid"}));
    command
        ->add_option("--encoding", o.encoding,
                     "how the colours of RGB rasters hold heights: terrain-rgb (Mapbox) or terrarium (Mapzen)")
        ->check(CLI::IsMember({"terrain-rgb", "terrarium"}));
    command->add_option("--drape", o.drape, "image to drape the terrain with: colour, grey or palette, georeferenced");
    command->add_option("--drape-crs", o.drape_crs, "coordinate system of that image where it does not state it");
    command->add_option(
        "--drape-extent", o.drape_extent,
        "W,S,E,N: outer edges of an image that does not say where it lies, in units of --drape-crs, else in degrees");
    add_optional(command, "--void", o.void_value, "the value that marks voids where the raster does not state it");
    add_optional(command, "--accuracy", o.accuracy_m,
                 "vertical accuracy of the source, LE90 in metres; a check without it believes the database")
        ->check(from_zero());
}

void add_builders(CLI::App& app, CommandLine& line) {
    add_convert(app, line);
    add_scenario(app, line);
    add_scene(app, line);
    add_terrain(app, line);
    add_pack(app, line);
}

}  // namespace tedavis::host_sim
