#include "shot/render_batch.h"

#include <map>

#include <fmt/format.h>

#include "config/read.h"

namespace overfly {
namespace {

// Which shot of the batch writes which frames.
class Outputs {
  public:
    // Throws UserError where another shot writes them already.
    void claim(const ShotDocument& shot) {
        const std::filesystem::path frames = shot.output.folder / (shot.output.name + ".*.exr");
        const auto [owner, is_new] =
            owner_of_.try_emplace(std::filesystem::absolute(frames).lexically_normal(), shot.file);
        if (is_new || owner->second == shot.file) return;
        throw UserError({shot.file}, fmt::format("writes the same frames as {}, {}; give it another output.folder or "
                                                 "output.name",
                                                 owner->second.string(), frames.string()));
    }

  private:
    std::map<std::filesystem::path, std::filesystem::path> owner_of_;
};

}  // namespace

std::vector<ShotOutcome> render_batch(std::span<const std::filesystem::path> shots,
                                      std::span<const std::string> overrides, const RenderOptions& options) {
    std::vector<ShotOutcome> outcomes;
    Outputs outputs;
    for (const std::filesystem::path& shot : shots) {
        ShotOutcome outcome;
        outcome.shot = shot;
        if (options.say) options.say("shot " + shot.string());
        try {
            const ShotDocument document = read_shot_document(shot, overrides);
            outputs.claim(document);
            outcome.result = render_shot(document, options);
        } catch (const UserError& error) {
            outcome.problems = error.problems();
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception& error) {
            // The batch goes on: hours of other shots must not be lost to one that shows a fault of ours.
            outcome.problems = {{{}, std::string("internal error: ") + error.what()}};
            outcome.our_fault = true;
        }
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

}  // namespace overfly
