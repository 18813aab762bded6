// The rendering thread of the viewer: live frames while the view changes, the reference at rest.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "view/exposure_meter.h"
#include "view/scene_edits.h"
#include "view/view_frames.h"

namespace gp::tool::view {

// All calls of the library but gpCancelRender are made by this thread, so that the window, which
// never waits for it, answers whatever the scene costs.
class ViewRenderer {
public:
    // `wake` is called on the rendering thread when there is something to take. The scene must
    // outlive the renderer.
    ViewRenderer(const ViewedScene& scene, std::function<void()> wake);
    ~ViewRenderer();  // cancels what is being rendered
    ViewRenderer(const ViewRenderer&) = delete;
    ViewRenderer& operator=(const ViewRenderer&) = delete;

    // What to show from now on; to be called every frame of the window. Returns the number of
    // these choices: pictures bear it.
    std::uint64_t show(const ViewChoices& choices);
    // The newest picture, once.
    std::optional<ShownPicture> take();
    // Writes the picture that is shown, .png or .exr (with all layers). Told by a note.
    void save(const std::string& path);
    bool isSaving() const;
    std::vector<ViewNote> takeNotes();

private:
    enum class Job { live, reshow, rest, beside, save, stop };

    void run();
    Job nextJob(std::unique_lock<std::mutex>& lock);
    void work(Job job, const ViewChoices& choices, std::uint64_t serial);
    void renderLive(const ViewChoices& choices);
    void renderAtRest(const ViewChoices& choices);
    void renderBeside(const ViewChoices& choices);
    std::optional<Job> besideJob() const;
    void publish(const ViewChoices& choices, std::uint64_t serial, bool isNewLive);
    void saveNow(const std::string& path);
    void note(bool isError, const std::string& text);
    static int onProgress(void* user, const GpProgress* progress);

    GpDevice m_device;
    GpScene m_scene;
    std::function<void()> m_wake;

    // Shared by both threads, under the mutex.
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    ViewChoices m_choices;
    std::uint64_t m_serial = 0;
    std::optional<ShownPicture> m_picture;
    struct Save {
        std::string path;
        std::uint64_t serial = 0;  // of the choices when it was asked for
    };
    std::vector<Save> m_toSave;
    std::vector<ViewNote> m_notes;
    bool m_stop = false, m_saving = false, m_cancellable = false;
    std::uint64_t m_workingOn = 0;  // the serial of the choices that are being rendered

    // The rendering thread's own.
    SceneEdits m_edits;
    ViewFrames m_frames;
    ExposureMeter m_meter;
    std::optional<ViewChoices> m_traced;  // what the frames show
    std::uint64_t m_shownSerial = 0, m_tracedSerial = 0;
    bool m_failed = false;                // these choices: nothing is tried until they change
    bool m_restHeld = false;              // the frame at rest has samples of this view
    bool m_besideHeld = false;            // the same of the reference beside
    bool m_besideDue = false;             // it is its turn: a live frame has come since
    std::chrono::steady_clock::time_point m_lastChange, m_lastPublished;

    std::thread m_thread;  // last: all above is there when it starts
};

}  // namespace gp::tool::view
