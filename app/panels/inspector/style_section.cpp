#include "app/panels/inspector/style_section.h"

#include "app/panels/inspector/rows/combo_row.h"
#include "app/session/editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/paint/style_function.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>

namespace suffuse {

namespace {

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
        const Locks isLocked(inspected.painting->groups);
        for (std::size_t i = 0; i < inspected.refs.size(); ++i) {
            const InspectedSegment &now = inspected.segments[i];
            if (isLocked(*now.stroke))
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
    m_washNote = quietLabel(tr("The style of the wash is seen in place of this one."), this);
    column->addWidget(m_washNote);
    QGridLayout *grid = addFieldGrid(*column);
    addCombos(*grid);
    m_xi = XiFields(*grid, 2, this);
    connectXi();
}

void StyleSection::addCombos(QGridLayout &grid)
{
    m_source = ComboRow::add(grid, 0, tr("Belongs to"),
                             tr("Whether the segments follow their stroke's style or have their own."),
                             {tr("The stroke"), tr("These segments")}, this)
                   .box;
    m_kind = ComboRow::add(grid, 1, tr("Kind"), tr("How density becomes coverage."), styleNames(), this).box;
    connect(m_source, &QComboBox::activated, this, [this](int index) { chooseSource(index == 1); });
    connect(m_kind, &QComboBox::activated, this, [this](int index) {
        const Style style = XiFields::defaultStyle(StyleKind(index));
        changeStyles(
            [style](Style &s) {
                if (s.kind != style.kind)
                    s = style;
            },
            tr("Change style"), nullptr);
    });
}

void StyleSection::connectXi()
{
    for (int i = 0; i < 3; ++i) {
        SliderField *row = m_xi[std::size_t(i)];
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
    m_washNote->setVisible(own == false && areInWashes(inspected));
    std::vector<Style> styles;
    styles.reserve(segments.size());
    for (const InspectedSegment &segment : segments)
        styles.push_back(segment.style());
    m_xi.show(styles);
    for (std::size_t i = 0; kind && i < 3; ++i)
        forgetStyleChange(*m_xi[i], inspected, i);
    m_xi.setValues(styles);
}

} // namespace suffuse
