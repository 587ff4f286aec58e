#include "host_sim/commands/compare.hpp"

#include <filesystem>
#include <memory>

#include "host_sim/atomic_file.hpp"
#include "host_sim/comparison/comparison_json.hpp"
#include "host_sim/comparison/comparison_page.hpp"
#include "host_sim/comparison/comparison_words.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/written_files.hpp"

namespace tedavis::host_sim {
namespace {

std::string folder_of(const std::string& file) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

void require_page_name(const std::string& output) {
    if (output.empty() || output.back() == '/' || std::filesystem::is_directory(output))
        throw UserError("-o " + output + ": this is a folder; name the page in it, such as page.html");
    if (std::filesystem::path(output).filename() == kCompareJsonName)
        throw UserError("-o " + output + ": " + kCompareJsonName +
                        " is the name of the file for scripts that stands beside the page; name the page otherwise, such as "
                        "page.html");
}

struct FoundTerrain {
    std::unique_ptr<OpenDatabase> database;
    std::string why_none;  // a sentence, where there is none
};

/// What file_of_run() has searched.
std::string not_found_words(const std::string& file) {
    return std::filesystem::path(file).is_absolute() ? "neither there nor in the folder of the run"
                                                     : "neither in its folder, nor in those above it, nor in the working folder";
}

/// The page says why it has no terrain, so that a database that has moved since is no error.
FoundTerrain terrain_below(const RunComparison& runs) {
    FoundTerrain found;
    std::string why;
    for (const ComparedRun* const run : {&runs.a, &runs.b}) {
        if (run->terrain.empty()) continue;
        const std::optional<std::string> path = file_of_run(run->folder, run->terrain);
        if (!path) {
            why += " " + run->terrain + " of " + run->folder + " is " + not_found_words(run->terrain) + ".";
            continue;
        }
        try {
            found.database = std::make_unique<OpenDatabase>(*path);
            return found;
        } catch (const UserError& error) {
            why += std::string(" ") + error.what() + ".";
        }
    }
    found.why_none = "The map has no terrain:" + (why.empty() ? " neither run names a terrain database." : why);
    return found;
}

std::string result_text(const RunComparison& runs, const std::string& page) {
    std::string text = comparison_title(runs);
    for (const std::string& sentence : difference_sentences(runs)) text += "\n  " + sentence;
    return text + "\n" + page + ": " + counted(runs.aligned.instants.size(), "instant") + ", aligned by " +
           name_of(runs.aligned.by);
}

}  // namespace

int run_compare(const CompareOptions& options, Console& console) {
    require_page_name(options.output);
    const std::string json_path = folder_of(options.output) + "/" + kCompareJsonName;
    require_replaceable(options.output, kComparisonPageBeginning, "page of a comparison");
    require_replaceable(json_path, "{\n  \"comparison\":", "comparison");
    const RunComparison runs = compared_runs(read_compared_run(options.run_a), read_compared_run(options.run_b), options.align);
    if (options.align.within_m && runs.aligned.by != Alignment::place)
        console.note(std::string("note: the runs are aligned by ") + name_of(runs.aligned.by) +
                     ", so that --within changes nothing; --align place takes places");
    for (const std::string& warning : comparison_warnings(runs)) console.note("warning: " + warning);
    const FoundTerrain terrain = terrain_below(runs);
    const std::string page = comparison_page(runs, comparison_moments(runs),
                                             {terrain.database ? &terrain.database->database() : nullptr, terrain.why_none});
    const std::string json = json_text(comparison_json(runs), 2) + "\n";
    NewFolder folder(folder_of(options.output));
    WrittenFiles written;
    written.add_new(options.output);
    write_file_atomically(options.output, page);
    write_file_atomically(json_path, json);
    written.keep();
    folder.keep();
    console.result(result_text(runs, options.output), json);
    return 0;
}

}  // namespace tedavis::host_sim
