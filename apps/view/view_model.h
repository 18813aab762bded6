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
    // Returns whether the drag is one of the divider's.
    bool dragDivider(const FrameInput& input, const PictureArea& area);

    SceneFacts m_facts;
    FlyCamera m_camera;
    ViewChoices m_choices;
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
