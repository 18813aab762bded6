// The panels of the viewer, drawn with Dear ImGui: they show a ViewModel and change it.
#pragma once

#include "view/view_model.h"

namespace gp::tool::view {

// In Dear ImGui's coordinates. One column at the left; the picture has the rest.
constexpr float kPanelWidth = 340;

void drawPanels(ViewModel& model, float height);

// The parts, one below the other.
void drawFramePanel(ViewModel& model);
void drawRealtimePanel(ViewModel& model);
void drawSeaPanel(ViewModel& model);
void drawCameraPanel(ViewModel& model);
void drawPicturePanel(ViewModel& model);
void drawLightPanel(ViewModel& model);
void drawSceneLights(ViewModel& model);  // within the light panel
void drawThingPanel(ViewModel& model);
void drawKeys();

// Over the picture, in the background.
void drawOverPicture(const ViewModel& model, const PictureArea& area);

}  // namespace gp::tool::view
