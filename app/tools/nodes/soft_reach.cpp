#include "app/tools/nodes/soft_reach.h"

#include "app/session/settings/settings.h"
#include "app/tools/nodes/node_marks.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/numbers/number_field.h"
#include "model/brush/stroke_fit.h"
#include "model/shaping/nodes/coarse_nodes.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace suffuse {

namespace {

constexpr double usualReach = 150;    ///< logical pixels, some five gaps between shown nodes
constexpr double leastReach = 6;      ///< logical pixels; a shorter one takes nothing along
constexpr double greatestReach = 1e6; ///< canvas units
constexpr double shortSegment = 1.5;  ///< in gaps between shown nodes; by itself such a segment would bend to a hairpin
constexpr double reachStep = 1.189207115002721; ///< four steps double it

QString reachKey()
{
    return QStringLiteral("tools/nodeReach");
}

} // namespace

SoftReach::SoftReach(QObject *parent) : QObject(parent)
{
    bool isNumber = false;
    const double stored = settings::store().value(reachKey()).toDouble(&isNumber);
    if (isNumber && stored >= 0 && stored <= greatestReach)
        m_chosen = stored;
}

void SoftReach::choose(std::optional<double> reach)
{
    if (reach)
        reach = std::clamp(*reach, 0.0, greatestReach);
    if (reach != m_chosen) {
        m_chosen = reach;
        settings::store().setValue(reachKey(), reach ? QVariant(*reach) : QVariant(QStringLiteral("view")));
    }
    update();
}

double SoftReach::usual(const View &view, double dpr)
{
    return usualReach * dpr / view.scale;
}

double SoftReach::ofNode(const Stroke &stroke, int node, const View &view, double dpr) const
{
    if (m_chosen)
        return *m_chosen;
    const double reach = usual(view, dpr);
    return isCrowded(stroke, placeOfNode(stroke, node), NodeMarks::gap(view, dpr), reach) ? reach : 0;
}

double SoftReach::ofCurve(const Stroke &stroke, const CurvePlace &place, const View &view, double dpr) const
{
    if (m_chosen)
        return *m_chosen;
    const double reach = usual(view, dpr), gap = NodeMarks::gap(view, dpr);
    const bool isShort = arcLength(stroke.cubicOf(stroke.segments[std::size_t(place.segment)])) < shortSegment * gap;
    return isShort || isCrowded(stroke, place, gap, reach) ? reach : 0;
}

double SoftReach::settled(double reach, const View &view, double dpr)
{
    return reach * view.scale < leastReach * dpr ? 0 : std::min(reach, greatestReach);
}

double SoftReach::stepped(double reach, double steps, const View &view, double dpr)
{
    if (reach > 0)
        return settled(reach * std::pow(reachStep, steps), view, dpr);
    return steps > 0 ? NodeMarks::gap(view, dpr) : 0;
}

void SoftReach::addTo(QHBoxLayout &row)
{
    m_field = addNumber(row, tr("Reach"),
                        tr("How far along the stroke a dragged node or curve takes along what lies near; "
                           "0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)"),
                        [this](double reach) { choose(reach); });
    m_field->setRange(0, greatestReach);
    m_field->setDisplay(lengthDisplay());
    m_follows = new QToolButton(row.parentWidget());
    m_follows->setText(tr("Auto"));
    m_follows->setToolTip(tr("Let the reach follow the view: soft where nodes would crowd, else the node alone"));
    m_follows->setAccessibleName(tr("Let the reach follow the view"));
    m_follows->setCheckable(true);
    connect(m_follows, &QToolButton::clicked, this,
            [this](bool follows) { choose(follows ? std::nullopt : std::optional(m_field->value().value_or(0))); });
    row.addWidget(m_follows);
    update();
}

void SoftReach::showInEffect(std::optional<double> reach)
{
    m_inEffect = reach;
    update();
}

void SoftReach::follow(const View &view, double dpr)
{
    m_usual = usual(view, dpr);
    if (!m_inEffect && !m_chosen)
        update();
}

void SoftReach::update()
{
    if (m_field)
        m_field->setValue(m_inEffect ? m_inEffect : m_chosen ? m_chosen : m_usual);
    if (m_follows)
        m_follows->setChecked(!m_chosen);
}

} // namespace suffuse
