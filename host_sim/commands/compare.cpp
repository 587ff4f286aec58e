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

/// The page says where it has no terrain, so that a database that has moved since is no error.
std::unique_ptr<OpenDatabase> terrain_below(const RunComparison& runs) {
    for (const ComparedRun* const run : {&runs.a, &runs.b}) {
        if (run->terrain.empty() || !std::filesystem::is_regular_file(run->terrain)) continue;
        try {
            return std::make_unique<OpenDatabase>(run->terrain);
        } catch (const UserError&) {
            continue;
        }
    }
    return nullptr;
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
    for (const std::string& warning : comparison_warnings(runs)) console.note("warning: " + warning);
    const std::unique_ptr<OpenDatabase> terrain = terrain_below(runs);
    const std::string page = comparison_page(runs, comparison_moments(runs), terrain ? &terrain->database() : nullptr);
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
