#include "shot/render_batch.h"

#include "config/read.h"

namespace overfly {

std::vector<ShotOutcome> render_batch(std::span<const std::filesystem::path> shots,
                                      std::span<const std::string> overrides, const RenderOptions& options) {
    std::vector<ShotOutcome> outcomes;
    for (const std::filesystem::path& shot : shots) {
        ShotOutcome outcome;
        outcome.shot = shot;
        if (options.say) options.say("shot " + shot.string());
        try {
            outcome.result = render_shot(read_shot_document(shot, overrides), options);
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
