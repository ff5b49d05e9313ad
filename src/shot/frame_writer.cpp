#include "shot/frame_writer.h"

#include <optional>
#include <utility>

namespace overfly {
namespace {

// The manifest is written anew as a whole: seldom enough that it doesn't count beside the frames.
constexpr double kSaveEvery_s = 1.0;

}  // namespace

FrameWriter::FrameWriter(Finish finish, const FrameStorage& storage, SequenceManifest& manifest)
    : finish_frame_(std::move(finish)), storage_(storage), manifest_(&manifest) {}

FrameWriter::~FrameWriter() {
    const std::scoped_lock lock(mutex_);
    waiting_.clear();
}

void FrameWriter::write(FrameOnFilm frame) {
    {
        const std::scoped_lock lock(mutex_);
        if (error_ != nullptr) return;
        waiting_.push_back(std::move(frame));
        ++in_hand_;
    }
    tasks_.run([this] { write_next(); });
}

std::size_t FrameWriter::in_hand() const {
    const std::scoped_lock lock(mutex_);
    return in_hand_;
}

void FrameWriter::wait() { tasks_.wait(); }

bool FrameWriter::has_failed() const {
    const std::scoped_lock lock(mutex_);
    return error_ != nullptr;
}

int FrameWriter::frames_written() const {
    const std::scoped_lock lock(mutex_);
    return written_;
}

double FrameWriter::seconds() const {
    const std::scoped_lock lock(mutex_);
    return seconds_;
}

// There are as many tasks as frames, but whoever comes first takes the oldest: threads don't take tasks in order.
void FrameWriter::write_next() {
    std::optional<FrameOnFilm> next;
    {
        const std::scoped_lock lock(mutex_);
        if (waiting_.empty()) return;  // discarded
        next = std::move(waiting_.front());
        waiting_.pop_front();
    }
    const Stopwatch watch;
    try {
        const FinishedFrame finished = finish_frame_(next->frame, std::move(next->film));
        const FrameDigest digest = write_digested_frame(next->frame.file, finished.picture, finished.header, storage_);
        list(manifest_frame(next->frame, digest, next->render_s));
    } catch (...) {
        fail(std::current_exception());
    }
    next.reset();  // before its place is another's
    const std::scoped_lock lock(mutex_);
    --in_hand_;
    seconds_ += watch.seconds();
}

void FrameWriter::list(ManifestFrame frame) {
    const std::scoped_lock lock(manifest_mutex_);
    manifest_->add(std::move(frame));
    {
        const std::scoped_lock counting(mutex_);
        ++written_;
    }
    if (since_saved_.seconds() > kSaveEvery_s) save();
}

void FrameWriter::save() {
    manifest_->save();
    since_saved_ = Stopwatch();
}

void FrameWriter::fail(std::exception_ptr error) {
    const std::scoped_lock lock(mutex_);
    if (error_ == nullptr) error_ = std::move(error);
    in_hand_ -= waiting_.size();
    waiting_.clear();
}

void FrameWriter::finish() {
    tasks_.wait();
    const Stopwatch watch;
    try {
        const std::scoped_lock lock(manifest_mutex_);
        save();
    } catch (...) {
        fail(std::current_exception());
    }
    const std::scoped_lock lock(mutex_);
    seconds_ += watch.seconds();
    if (error_ != nullptr) std::rethrow_exception(error_);
}

void FrameWriter::discard() {
    {
        const std::scoped_lock lock(mutex_);
        in_hand_ -= waiting_.size();
        waiting_.clear();
    }
    finish();
}

}  // namespace overfly
