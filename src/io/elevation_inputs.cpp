#include "io/elevation_inputs.h"

#include "core/error.h"
#include "io/raster_dataset.h"

namespace overfly {

std::vector<std::filesystem::path> elevation_inputs(const ElevationSource& source) {
    std::vector<std::filesystem::path> inputs;
    std::vector<Problem> problems;
    for (const std::filesystem::path& file : source.dem) {
        try {
            const RasterDataset dataset = open_raster(file);
            for (std::filesystem::path& input : files_of(*dataset)) inputs.push_back(std::move(input));
        } catch (const UserError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    }
    if (!problems.empty()) throw UserError(std::move(problems));
    return inputs;
}

}  // namespace overfly
