#include "host_sim/evaluation/evaluate_pictures.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/evaluation/layer_mask.hpp"
#include "host_sim/evaluation/picture_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

void require_other_outputs(const std::vector<std::string>& files, const std::vector<std::string>& names,
                           const std::string& folder) {
    for (const std::string& name : names) {
        const ViewFiles views = view_files(folder + "/" + name);
        for (const std::string& view :
             {views.saliency, views.heat, views.edges, views.regions, views.second_opinion, views.sheet})
            require_other_file(view, files);
    }
}

}  // namespace

std::vector<std::string> view_names(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    for (const std::string& file : files) {
        const std::string stem = std::filesystem::path(file).stem().string();
        std::string name = stem;
        for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n) name = stem + "-" + std::to_string(n);
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> pictures_of_sheets(const std::vector<std::string>& inputs) {
    std::vector<std::string> files;
    for (const std::string& input : inputs) {
        const std::string record = input + "/" + kSheetJsonName;
        if (!std::filesystem::is_regular_file(record)) {
            if (!is_layer_mask(input)) files.push_back(input);
            continue;
        }
        const auto sheet = nlohmann::json::parse(read_file(record), nullptr, false);
        const auto pictures = sheet.is_object() ? sheet.value("pictures", nlohmann::json::array()) : nlohmann::json::array();
        if (!pictures.is_array() || pictures.empty()) throw UserError(record + ": names no pictures; write the sheet again");
        for (const auto& picture : pictures) files.push_back(input + "/" + picture.value("file", ""));
    }
    return files;
}

PictureGaze gaze_of_pictures(const FixationFile& file, const std::vector<std::string>& pictures) {
    if (!file.has_files && pictures.size() > 1)
        throw UserError(file.path + ":1: no column file; it says which of the " + std::to_string(pictures.size()) +
                        " pictures a fixation is on");
    PictureGaze gaze;
    gaze.of_picture.resize(pictures.size());
    for (const Fixation& fixation : file.fixations) {
        bool is_found = false;
        for (std::size_t n = 0; n < pictures.size(); ++n) {
            const bool is_meant = !file.has_files || fixation.file == pictures[n] || fixation.file == file_name(pictures[n]);
            if (is_meant) gaze.of_picture[n].push_back(&fixation);
            is_found = is_found || is_meant;
        }
        gaze.of_others += is_found ? 0 : 1;
    }
    return gaze;
}

std::vector<EvaluatedPicture> evaluate_pictures(const std::vector<std::string>& files, const std::string& folder,
                                                const FixationFile* file, const EvaluationWork& work) {
    const std::vector<std::string> names = view_names(files);
    require_other_outputs(files, names, folder);
    PictureGaze gaze;
    if (file != nullptr) gaze = gaze_of_pictures(*file, files);
    std::vector<EvaluatedPicture> evaluated;
    const auto measure = [&](PictureMeter& meter, std::size_t n) {
        const RgbaPicture picture = read_picture(files[n]);
        const auto mask = read_layer_mask(files[n], layer_names_beside(files[n]), picture.width, picture.height);
        const std::vector<GazePixel> pixels =
            file == nullptr ? std::vector<GazePixel>() : gaze_pixels(*file, gaze.of_picture[n], picture.width, picture.height);
        PictureMeasures measures = meter.measure(picture, files[n], mask ? &*mask : nullptr, pixels);
        const PictureViews views = picture_views(picture, meter, measures, work.settings);
        write_views(folder, names[n], file_name(files[n]), picture, views, measures);
        return EvaluatedPicture{files[n], names[n], std::move(measures)};
    };
    (void)for_each_picture(work, "pictures", files.size(), measure,
                           [&](std::size_t, EvaluatedPicture&& one) { evaluated.push_back(std::move(one)); });
    return evaluated;
}

}  // namespace tedavis::host_sim
