#include "view/view_renderer.h"

#include <fmt/format.h>

#include <chrono>

#include "tool_error.h"

namespace gp::tool::view {
namespace {

using Clock = std::chrono::steady_clock;

// A hand that stops for a moment has not come to rest yet.
constexpr auto kRestDelay = std::chrono::milliseconds(200);

}  // namespace

ViewRenderer::ViewRenderer(const ViewedScene& scene, std::function<void()> wake)
    : m_device(scene.device),
      m_scene(scene.scene),
      m_wake(std::move(wake)),
      m_edits(scene),
      m_frames(scene.device),
      m_lastChange(Clock::now()),
      m_thread([this] { run(); }) {}

ViewRenderer::~ViewRenderer() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_all();
    // A cancel that comes just before its render begins is lost; that render is then ended by its
    // progress, after its first sample.
    gpCancelRender(m_device);
    m_thread.join();
}

std::uint64_t ViewRenderer::show(const ViewChoices& choices) {
    const std::lock_guard lock(m_mutex);
    if (m_serial == 0 || !sameChoices(choices, m_choices)) {
        m_choices = choices;
        ++m_serial;
        m_changed.notify_all();
    }
    // Again and again, since a cancel that comes before its render begins is lost.
    if (m_cancellable && m_workingOn != m_serial) {
        gpCancelRender(m_device);
    }
    return m_serial;
}

std::optional<ShownPicture> ViewRenderer::take() {
    const std::lock_guard lock(m_mutex);
    std::optional<ShownPicture> picture;
    picture.swap(m_picture);
    return picture;
}

void ViewRenderer::save(const std::string& path) {
    const std::lock_guard lock(m_mutex);
    m_toSave.push_back({path, m_serial});
    m_changed.notify_all();
}

bool ViewRenderer::isSaving() const {
    const std::lock_guard lock(m_mutex);
    return m_saving || !m_toSave.empty();
}

std::vector<ViewNote> ViewRenderer::takeNotes() {
    const std::lock_guard lock(m_mutex);
    std::vector<ViewNote> notes;
    notes.swap(m_notes);
    return notes;
}

void ViewRenderer::note(bool isError, const std::string& text) {
    {
        const std::lock_guard lock(m_mutex);
        m_notes.push_back({isError, text});
    }
    m_wake();
}

// Returns with the lock held.
ViewRenderer::Job ViewRenderer::nextJob(std::unique_lock<std::mutex>& lock) {
    for (;;) {
        if (m_stop) {
            return Job::stop;
        }
        const bool isNew = m_serial != m_shownSerial;
        const bool canBeSeen = m_choices.size.width > 0 && m_choices.size.height > 0;
        if (m_serial == 0 || !canBeSeen || (m_failed && !isNew)) {
            if (!m_toSave.empty()) {
                return Job::save;
            }
            m_changed.wait(lock);
            continue;
        }
        // Also while hands move: a live frame is seen with the first sample that belongs to it.
        if (m_traced && m_traced->beside && m_besideDue && m_frames.samplesBeside() == 0) {
            return Job::beside;
        }
        // Before the next step of what moves all the time, a sea, which would put it off for ever.
        if (m_traced && !m_toSave.empty() && m_shownSerial >= m_toSave.front().serial) {
            return Job::save;
        }
        if (!m_traced || !sameView(*m_traced, m_choices)) {
            return Job::live;
        }
        if (isNew) {
            return Job::reshow;
        }
        if (m_choices.beside) {
            if (const std::optional<Job> job = besideJob()) {
                return *job;
            }
            m_changed.wait(lock);
            continue;
        }
        const bool goesOn = m_choices.live == LiveMode::realtime;
        const bool isAtRest = Clock::now() >= m_lastChange + kRestDelay;
        if (m_choices.reference && m_frames.samplesAtRest() >= m_choices.mostSamples) {
            m_changed.wait(lock);
        } else if (m_choices.reference && isAtRest) {
            return Job::rest;
        } else if (goesOn) {
            return Job::live;  // noise goes on to fade
        } else if (m_choices.reference) {
            m_changed.wait_until(lock, m_lastChange + kRestDelay);
        } else {
            m_changed.wait(lock);
        }
    }
}

// In turns: a live frame, samples of the reference.
std::optional<ViewRenderer::Job> ViewRenderer::besideJob() const {
    const bool hasAll = m_frames.samplesBeside() >= m_choices.mostSamples;
    const bool goesOn = m_choices.live == LiveMode::realtime;
    if (!hasAll && (m_besideDue || !goesOn)) {
        return Job::beside;
    }
    return goesOn ? std::optional(Job::live) : std::nullopt;
}

void ViewRenderer::run() {
    for (;;) {
        std::unique_lock lock(m_mutex);
        const Job job = nextJob(lock);
        if (job == Job::stop) {
            return;
        }
        const bool isOfLive = job == Job::beside;  // what hands have changed since is not in it
        const ViewChoices choices = isOfLive ? *m_traced : m_choices;
        const std::uint64_t serial = isOfLive ? m_tracedSerial : m_serial;
        m_workingOn = serial;
        m_cancellable = job == Job::rest || (isOfLive && m_frames.samplesBeside() > 0);
        m_saving = job == Job::save;
        lock.unlock();
        try {
            work(job, choices, serial);
            m_failed = false;
        } catch (const std::exception& error) {
            if (job != Job::save) {
                m_failed = true;
                m_traced.reset();
            }
            note(true, error.what());
        }
        m_shownSerial = job == Job::save ? m_shownSerial : serial;
        lock.lock();
        m_cancellable = false;
        m_saving = false;
    }
}

void ViewRenderer::work(Job job, const ViewChoices& choices, std::uint64_t serial) {
    switch (job) {
        case Job::live: renderLive(choices); break;
        case Job::rest: renderAtRest(choices); break;
        case Job::beside: renderBeside(choices); break;
        case Job::save: {
            std::unique_lock lock(m_mutex);
            const std::string path = m_toSave.front().path;
            m_toSave.erase(m_toSave.begin());
            lock.unlock();
            saveNow(path);
            return;
        }
        default: break;
    }
    if (job == Job::live || job == Job::reshow) {
        m_traced = choices;
        m_tracedSerial = serial;
    }
    if (job == Job::live && choices.beside && m_frames.samplesBeside() == 0) {
        m_frames.noteLiveTime();  // it is shown with the first sample beside
        return;
    }
    publish(choices, serial, job == Job::live);
}

void ViewRenderer::renderLive(const ViewChoices& choices) {
    if (!m_traced || !sameView(*m_traced, choices)) {
        m_lastChange = Clock::now();
        m_besideHeld = false;
        m_frames.forgetBeside();
    }
    m_restHeld = false;
    m_besideDue = true;
    m_edits.apply(choices);
    m_frames.renderLive(m_scene, choices);
}

void ViewRenderer::renderBeside(const ViewChoices& choices) {
    const bool isFirst = m_frames.samplesBeside() == 0;
    m_besideDue = false;
    m_frames.renderBeside(m_scene, choices, isFirst ? nullptr : &ViewRenderer::onProgress, this,
                          !m_besideHeld);
    m_besideHeld = true;
}

void ViewRenderer::renderAtRest(const ViewChoices& choices) {
    m_frames.renderAtRest(m_scene, choices, &ViewRenderer::onProgress, this,
                          !m_restHeld);
    m_restHeld = true;
}

// On the rendering thread, after each batch of samples.
int ViewRenderer::onProgress(void* user, const GpProgress*) {
    ViewRenderer& self = *static_cast<ViewRenderer*>(user);
    const std::lock_guard lock(self.m_mutex);
    return self.m_stop || self.m_serial != self.m_workingOn ? 1 : 0;
}

void ViewRenderer::publish(const ViewChoices& choices, std::uint64_t serial, bool isNewLive) {
    const Clock::time_point now = Clock::now();
    float ev = choices.exposureEv;
    if (eyeDecides(choices)) {
        ev = m_frames.exposureOfLive();
    } else if (choices.autoExposure) {
        const std::chrono::duration<double> passed = now - m_lastPublished;
        ev = m_meter.adapt(m_frames.readColor(), passed.count());
    }
    m_lastPublished = now;
    m_frames.tonemap(ev, choices.tonemap);
    ShownPicture picture = m_frames.read(
        choices.image, ev, choices.beside ? std::optional(choices.divider) : std::nullopt);
    picture.serial = serial;
    picture.exposureEv = ev;
    if (isNewLive) {
        picture.secondsFrame = m_frames.noteLiveTime();
    }
    {
        const std::lock_guard lock(m_mutex);
        m_picture = std::move(picture);
    }
    m_wake();
}

void ViewRenderer::saveNow(const std::string& path) {
    GpSaveOptions options{};
    if (path.ends_with(".exr")) {
        options.layers = m_frames.layersOfShown();
    }
    if (m_frames.shown() == nullptr) {
        throw RunError(fmt::format("{}: there is no picture yet", path));
    }
    const std::uint32_t beside = m_traced && m_traced->beside ? m_frames.samplesBeside() : 0;
    if (beside > 0) {
        m_frames.saveBeside(path, m_traced->divider);
    } else {
        check(m_device, gpSaveFrame(m_frames.shown(), path.c_str(), &options));
    }
    const RenderSize size = m_frames.shownSize();
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(m_frames.shown(), &statistics));
    note(false, fmt::format("saved {} ({}x{}, {} samples a pixel)", path, size.width, size.height,
                            beside > 0 ? beside : statistics.samplesPerPixel));
}

}  // namespace gp::tool::view
