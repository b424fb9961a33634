#include "app/session/drawing_aids.h"

#include <algorithm>
#include <numbers>

namespace suffuse {

namespace {

constexpr std::size_t mostGuides = 1000;
constexpr std::size_t mostAssistants = 100;

} // namespace

void DrawingAids::setSymmetry(Symmetry symmetry)
{
    symmetry.arms = std::clamp(symmetry.arms, Symmetry::leastArms, Symmetry::mostArms);
    symmetry.angle = std::remainder(symmetry.angle, 2 * std::numbers::pi);
    if (symmetry == m_symmetry)
        return;
    m_symmetry = symmetry;
    emit changed();
}

Symmetry DrawingAids::usualSymmetry(const Rect &canvas)
{
    Symmetry usual;
    usual.centre = {0.5 * (canvas.left + canvas.right), 0.5 * (canvas.top + canvas.bottom)};
    return usual;
}

void DrawingAids::setGuides(std::vector<Guide> guides)
{
    if (guides.size() > mostGuides)
        guides.resize(mostGuides);
    if (guides == m_guides)
        return;
    m_guides = std::move(guides);
    emit changed();
}

void DrawingAids::setAssistants(std::vector<Assistant> assistants)
{
    std::erase_if(assistants, [](const Assistant &assistant) { return !assistant.isSound(); });
    if (assistants.size() > mostAssistants)
        assistants.resize(mostAssistants);
    if (assistants == m_assistants)
        return;
    m_assistants = std::move(assistants);
    emit changed();
}

void DrawingAids::reset(const Rect &canvas)
{
    emit aboutToReset();
    m_symmetry = usualSymmetry(canvas);
    m_guides.clear();
    m_assistants.clear();
    emit changed();
}

} // namespace suffuse
