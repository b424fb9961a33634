#include "app/panels/inspector/style_section.h"

#include "app/session/editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/painting/fields.h"
#include "model/painting/validate.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>

#include <cmath>

namespace suffuse {

namespace {

/// The factor is a little smaller than allowed, since the bound must hold after rounding to float.
const double edgeFactor = greatestLightening() * (1 - 1e-7);

/// The indices of the target segments of each stroke.
std::map<StrokeId, std::vector<int>> targetsByStroke(const Document &document)
{
    std::map<StrokeId, std::vector<int>> targets;
    for (const SegmentRef &ref : targetSegments(document))
        targets[ref.stroke].push_back(ref.segment);
    return targets;
}

/// A change that is shown is forgotten when the styles are not what it made of them any more.
void forgetStyleChange(SliderField &row, const Inspected &inspected, std::size_t xi)
{
    row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
        if (!start)
            return false;
        StrokePtr then;
        for (std::size_t i = 0; i < inspected.refs.size(); ++i) {
            const InspectedSegment &now = inspected.segments[i];
            if (inspected.painting->isLocked(*now.stroke))
                continue;
            if (!then || then->id != inspected.refs[i].stroke)
                then = start->find(inspected.refs[i].stroke);
            const auto k = std::size_t(inspected.refs[i].segment);
            if (!then || k >= then->segments.size() ||
                now.style().xi[xi] != float(change.applied(double(then->styleOf(then->segments[k]).xi[xi]))))
                return false;
        }
        return true;
    });
}

} // namespace

StyleSection::StyleSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(sectionTitle(tr("Style"), this));
    QGridLayout *grid = addFieldGrid(*column);
    addCombos(*grid);
    addXiRows(*grid);
}

void StyleSection::addCombos(QGridLayout &grid)
{
    const auto add = [&](int row, const QString &name, const QString &tip, const QStringList &items) {
        auto *label = new QLabel(name, this);
        auto *combo = new QComboBox(this);
        combo->addItems(items);
        combo->setPlaceholderText(QStringLiteral("—"));
        combo->setAccessibleName(name);
        combo->setToolTip(tip);
        combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        combo->setMinimumContentsLength(8);
        label->setBuddy(combo);
        grid.addWidget(label, row, 0);
        grid.addWidget(combo, row, 1, 1, 2);
        return combo;
    };
    m_source = add(0, tr("Belongs to"), tr("Whether the segments follow their stroke's style or have their own."),
                   {tr("The stroke"), tr("These segments")});
    m_kind = add(1, tr("Kind"), tr("How density becomes coverage."), styleNames());
    connect(m_source, &QComboBox::activated, this, [this](int index) { chooseSource(index == 1); });
    connect(m_kind, &QComboBox::activated, this, [this](int index) {
        const Style style = defaultStyle(StyleKind(index));
        changeStyles(
            [style](Style &s) {
                if (s.kind != style.kind)
                    s = style;
            },
            tr("Change style"), nullptr);
    });
}

void StyleSection::addXiRows(QGridLayout &grid)
{
    for (int i = 0; i < 3; ++i) {
        auto *row = new SliderField(xiSpec(Style{}.kind, i), grid, 2 + i, this);
        m_xi[std::size_t(i)] = row;
        connect(row, &SliderField::refused, this, &StyleSection::refused);
        connect(row, &SliderField::edited, this, [this, i](double value, ValueEntry *entry) {
            changeStyles(
                [=](Style &s) {
                    if (i < xiCount(s.kind))
                        s.xi[std::size_t(i)] = float(value);
                },
                tr("Change style"), entry);
        });
        connect(row, &SliderField::changed, this,
                [this, i](const ValueChange &change, ValueEntry *entry) { changeXiTogether(i, change, entry); });
        connect(row, &SliderField::editedRelative, this, [this, i](const ValueMap &map) {
            const auto change = [&](Style &s) {
                // A value beyond the range makes the style invalid, and the whole change is refused.
                s.xi[std::size_t(i)] = float(map(double(s.xi[std::size_t(i)])).value_or(-1));
            };
            changeStyles(change, tr("Change style"), nullptr);
        });
    }
}

Style StyleSection::defaultStyle(StyleKind kind)
{
    switch (kind) {
    case StyleKind::Uniform:
        return {kind, {0.5f, 0.05f, 0}};
    case StyleKind::Feathering:
        return {kind, {1, 1.5f, 0}};
    case StyleKind::Edge:
        return {kind, {0.6f, 0.65f, 0.9f}};
    }
    return {};
}

void StyleSection::chooseSource(bool own)
{
    Document &document = m_editor.document();
    std::map<StrokeId, std::vector<int>> targets = targetsByStroke(document);
    Edit edit = changeStrokes(document, document.selection().strokes, [&](Stroke &stroke) {
        for (const int index : targets[stroke.id]) {
            Segment &segment = stroke.segments[std::size_t(index)];
            if (!own)
                segment.style.reset();
            else if (!segment.style)
                segment.style = stroke.style;
        }
    });
    m_editor.push(std::move(edit), own ? tr("Give segments their own style") : tr("Follow the stroke's style"));
    refresh(inspect(document));
}

void StyleSection::changeStyles(const std::function<void(Style &)> &change, const QString &text, ValueEntry *entry)
{
    Document &document = m_editor.document();
    std::map<StrokeId, std::vector<int>> targets = targetsByStroke(document);
    QString problem;
    const auto changeChecked = [&](Style &style) {
        change(style);
        if (problem.isEmpty())
            problem = problemOf(style);
    };
    Edit edit = changeStrokes(document, document.selection().strokes, [&](Stroke &stroke) {
        bool strokeStyle = false;
        for (const int index : targets[stroke.id]) {
            Segment &segment = stroke.segments[std::size_t(index)];
            if (segment.style)
                changeChecked(*segment.style);
            else
                strokeStyle = true;
        }
        if (strokeStyle)
            changeChecked(stroke.style);
    });
    if (problem.isEmpty()) {
        m_editor.push(std::move(edit), text, entry);
    } else {
        emit refused(tr("Not possible for all that is selected: %1").arg(problem));
        refresh(inspect(document));
    }
}

void StyleSection::changeXiTogether(int index, const ValueChange &change, ValueEntry *entry)
{
    Document &document = m_editor.document();
    const auto xi = std::size_t(index);
    const PaintingPtr start = entry->start(document);
    std::map<StrokeId, std::vector<int>> targets = targetsByStroke(document);
    Edit edit = changeStrokes(document, document.selection().strokes, [&](Stroke &stroke) {
        const StrokePtr then = start->find(stroke.id);
        if (!then || then->segments.size() != stroke.segments.size())
            return;
        bool strokeStyle = false;
        for (const int k : targets[stroke.id]) {
            std::optional<Style> &own = stroke.segments[std::size_t(k)].style;
            const std::optional<Style> &was = then->segments[std::size_t(k)].style;
            strokeStyle = strokeStyle || !own;
            if (own && was)
                own->xi[xi] = float(change.applied(double(was->xi[xi])));
        }
        if (strokeStyle)
            stroke.style.xi[xi] = float(change.applied(double(then->style.xi[xi])));
    });
    m_editor.push(std::move(edit), tr("Change style"), entry);
}

void StyleSection::refresh(const Inspected &inspected)
{
    const auto &segments = inspected.segments;
    const auto own = commonValue(segments, [](const InspectedSegment &s) { return s.segment->style.has_value(); });
    const auto kind = commonValue(segments, [](const InspectedSegment &s) { return s.style().kind; });
    m_source->setCurrentIndex(own ? int(*own) : -1);
    m_kind->setCurrentIndex(kind ? int(*kind) : -1);
    refreshXi(inspected, kind);
}

void StyleSection::refreshXi(const Inspected &inspected, std::optional<StyleKind> kind)
{
    for (int i = 0; i < 3; ++i)
        m_xi[std::size_t(i)]->setVisible(kind && i < xiCount(*kind));
    if (!kind)
        return;
    nameXi(*kind);
    limitXi(inspected, *kind);
    for (std::size_t i = 0; i < 3; ++i)
        forgetStyleChange(*m_xi[i], inspected, i);
    for (std::size_t i = 0; i < 3; ++i)
        m_xi[i]->setValue(commonNumber(inspected.segments, [i](const InspectedSegment &s) { return s.style().xi[i]; }));
}

void StyleSection::nameXi(StyleKind kind)
{
    const Style fallback = defaultStyle(kind);
    for (std::size_t i = 0; i < 3; ++i) {
        const FieldSpec spec = xiSpec(kind, int(i));
        m_xi[i]->rename(spec.name, spec.toolTip);
        m_xi[i]->setDefaultValue(double(fallback.xi[i]));
    }
}

void StyleSection::limitXi(const Inspected &inspected, StyleKind kind)
{
    double lowestXi1 = positive.greatest, highestXi2 = positive.leastFloat();
    for (const InspectedSegment &s : inspected.segments) {
        lowestXi1 = std::min(lowestXi1, double(s.style().xi[0]));
        highestXi2 = std::max(highestXi2, double(s.style().xi[1]));
    }
    const auto domain = [kind](int index) { return domainOfXi(kind, index); };
    double xi1From = domain(0).leastFloat(), xi2To = domain(1).greatest;
    if (hasRim(kind)) {
        xi1From = highestXi2 / edgeFactor;
        xi2To = lowestXi1 * edgeFactor;
    }
    m_xi[0]->setRange(xi1From, domain(0).greatest);
    m_xi[1]->setRange(domain(1).leastFloat(), xi2To);
    m_xi[2]->setRange(domain(2).leastFloat(), domain(2).greatest);
    m_xi[0]->setSliderRange(std::max(0.02, xi1From), std::max(hasRim(kind) ? 2.0 : 4.0, 2 * xi1From));
    if (kind == StyleKind::Uniform)
        m_xi[1]->setSliderRange(0.002, 1);
    else
        m_xi[1]->setSliderRange(kind == StyleKind::Feathering ? 0.5 : std::min(0.02, xi2To / 2), std::min(xi2To, 64.0));
    m_xi[2]->setSliderRange(0.05, 1);
}

} // namespace suffuse
