// The state of the viewer: what panels, keys and scripts change, and what panels show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "view/denoiser_facts.h"
#include "view/fly_camera.h"
#include "view/input_state.h"
#include "view/scene_index.h"
#include "view/shown_picture.h"
#include "view/time_history.h"
#include "view/view_choices.h"

namespace gp::tool::view {

// What is known of the scene before the window opens.
struct SceneFacts {
    std::string path, deviceName;
    GpCameraDesc start{}, wholeScene{};
    std::vector<GpCameraDesc> cameras;  // the file's
    SceneIndex index;
    SceneLights lights;                 // when it was loaded, the sky's sun apart; may be null
    DenoiserFacts denoisers;
    float reach = 1;                    // metres to what is seen at first
};

// Where the picture lies in the window, pixels.
struct PictureArea {
    float x = 0, y = 0, width = 0, height = 0;
};

class ViewModel {
public:
    // How far from the divider a hand may take hold of it, pixels.
    static constexpr float kDividerReach = 8;

    ViewModel(SceneFacts facts, const ViewChoices& choices, std::string screenshotPath);

    // What hands did in a frame of the window. `seconds`: since the last one.
    void advance(const FrameInput& input, double seconds, const PictureArea& area);
    // A picture has come, or something to tell.
    void accept(ShownPicture picture);
    void accept(const ViewNote& note);

    // A panel's setting by name, as scripts write it. Throws UsageError.
    void set(const std::string& name, const std::string& value);
    static std::vector<std::string> settingNames();
    // Where things stand, for scripts.
    nlohmann::ordered_json stateJson() const;

    // A jump, not a flight.
    void goTo(const GpCameraDesc& camera);
    // Modes that do not go on at rest get a reference there.
    void setLive(LiveMode mode);
    void nextCamera();
    // The camera of the file by number; throws UsageError where there is none.
    void goToCamera(std::size_t index);
    void requestScreenshot() { m_screenshotWanted = true; }

    // The lights as they are now; never null.
    const std::vector<SceneLight>& lights() const;
    // The light of this number, to be changed; throws UsageError where there is none.
    void changeLight(std::size_t index, const std::function<void(SceneLight&)>& change);
    // Where the camera is; polygons are not made by hand.
    void addLight(GpLightKind kind);

    // The sea, also of a scene that came without; its settings stay while it is away.
    void setSeaThere(bool isThere);
    // Another sea at the same moment. Throws UsageError where there is none, and where no sea can
    // be like that; nothing has changed then.
    void changeSea(const GpOceanDesc& desc);
    // What a panel is changing, which asks for a new sea when it is let go.
    GpOceanDesc& seaDraft() { return m_seaDraft; }
    // changeSea with the draft; a fault is told as a message, and the draft is what it was.
    void finishSeaDraft();
    // These throw UsageError where there is none.
    void setSeaTime(double seconds);
    void setSeaSpeed(double speed);
    void pauseSea(bool isPaused);
    // Stands still a moment later.
    void stepSea();

    // What to render: the choices with the camera where it is now.
    ViewChoices choicesFor(RenderSize size) const;

    const SceneFacts& facts() const { return m_facts; }
    FlyCamera& camera() { return m_camera; }
    const FlyCamera& camera() const { return m_camera; }
    ViewChoices& choices() { return m_choices; }
    const ViewChoices& choices() const { return m_choices; }
    const std::optional<ShownPicture>& picture() const { return m_picture; }
    const TimeHistory& times() const { return m_times; }
    // Pinned by a click, else under the mouse.
    const std::optional<PickedThing>& thing() const { return m_pinned ? m_pinned : m_hovered; }
    bool isPinned() const { return m_pinned.has_value(); }
    // Whether the waves go on by themselves.
    bool seaMoves() const { return view::seaMoves(m_choices); }
    void unpin() { m_pinned.reset(); }
    const std::string& message() const { return m_message.text; }
    bool messageIsError() const { return m_message.isError; }
    std::string& screenshotPath() { return m_screenshotPath; }
    // Of the light panel.
    std::size_t& selectedLight() { return m_selectedLight; }
    bool showsPanels() const { return m_showsPanels; }
    bool wantsToQuit() const { return m_quit; }
    bool takeScreenshotRequest();

private:
    void press(Key key);
    void pick(const FrameInput& input, const PictureArea& area);
    std::optional<PickedThing> thingAt(std::uint32_t id) const;
    void needSea() const;
    void pressSea(Key key);
    nlohmann::ordered_json seaJson() const;
    void advanceSea(double seconds);
    // Returns whether the drag is one of the divider's.
    bool dragDivider(const FrameInput& input, const PictureArea& area);

    SceneFacts m_facts;
    FlyCamera m_camera;
    ViewChoices m_choices;
    GpOceanDesc m_seaDraft;
    std::string m_screenshotPath;
    std::optional<ShownPicture> m_picture;
    TimeHistory m_times;
    std::optional<PickedThing> m_hovered, m_pinned;
    std::uint32_t m_hoveredId = 0;
    std::size_t m_nextCamera = 0, m_selectedLight = 0;
    std::optional<glm::vec2> m_dividerDrag;  // where the drag began that holds the divider
    ViewNote m_message;
    bool m_showsPanels = true, m_quit = false, m_screenshotWanted = false;
};

}  // namespace gp::tool::view
