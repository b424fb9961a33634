#include "app/window/pointer/value_card.h"

#include "app/canvas/canvas_widget.h"
#include "app/panels/inspector/fill_section.h"
#include "app/panels/inspector/rows/erasure_rows.h"
#include "app/panels/inspector/rows/rewet_rows.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/editor.h"
#include "app/session/painting/seen_width.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "model/area/outline.h"
#include "model/painting/fields.h"
#include "undo/edits.h"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

constexpr int cardWidth = 320;
constexpr double narrowest = 0.01; // units

FieldSpec widthSpec()
{
    return {.name = ValueCard::tr("Width"),
            .toolTip = ValueCard::tr("From one visible edge of the paint to the other, at its widest, as it is now"),
            .display = lengthDisplay(),
            .minimum = narrowest,
            .maximum = 1e5,
            .sliderMinimum = 0.5,
            .sliderMaximum = 300,
            .logarithmic = true};
}

/// The width of an inspected segment; nothing for one that takes paint away, which has no edge that is seen.
std::optional<SeenWidth> seenOf(const Inspected &inspected, std::size_t index, Microseconds time)
{
    const auto &[stroke, segment] = inspected.segments[index];
    return segment->takesPaint() ? std::nullopt : seenWidth(*stroke, inspected.refs[index].segment, time);
}

} // namespace

ValueCard::ValueCard(CanvasWidget &canvas) : FloatingCard(canvas), m_canvas(canvas), m_editor(canvas.editor())
{
    setAccessibleName(tr("Values"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 12);
    column->setSpacing(4);
    addHead();
    QGridLayout *grid = addFieldGrid(*column);
    m_width = new SliderField(widthSpec(), *grid, 0, this);
    m_segments = new SegmentSection(m_editor, this);
    m_fill = new FillSection(m_editor, this);
    m_fill->showFew();
    m_hint = new HintLabel(this);
    column->addWidget(m_segments);
    column->addWidget(m_fill);
    column->addWidget(m_hint);
    alignFieldLabels(*this);
    connect(m_width, &SliderField::edited, this, &ValueCard::setWidth);
    connect(m_width, &SliderField::refused, this, &ValueCard::refuse);
    connect(m_fill, &FillSection::refused, this, &ValueCard::refuse);
    connect(m_segments, &SegmentSection::refused, this, &ValueCard::refuse);
    connect(&m_editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (isOpen() && (change.selection || change.reset || !change.strokes.empty()))
            refresh();
    });
}

void ValueCard::addHead()
{
    auto *head = new QHBoxLayout;
    m_title = sectionTitle(QString(), this);
    head->addWidget(m_title, 1);
    const auto button = [this, head](const QString &text, const QString &tip, bool whole) {
        auto *b = new QToolButton(this);
        b->setText(text);
        b->setToolTip(tip);
        b->setCheckable(true);
        b->setAutoExclusive(true);
        head->addWidget(b);
        connect(b, &QToolButton::clicked, this, [this, whole] { choose(whole); });
        return b;
    };
    m_whole = button(tr("Whole"), tr("All that is selected"), true);
    m_one = button(tr("Segment"), tr("The segment under the pointer alone"), false);
    static_cast<QVBoxLayout *>(layout())->addLayout(head);
}

void ValueCard::refuse(const QString &why)
{
    m_refused = !why.isEmpty();
    m_hint->showRefusal(why);
}

bool ValueCard::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && watched == QApplication::focusWidget()) // before the field knows of it
        m_refused = false;
    return FloatingCard::eventFilter(watched, event);
}

void ValueCard::keyPressEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_Escape && std::exchange(m_refused, false)) {
        event->accept();
        return;
    }
    FloatingCard::keyPressEvent(event);
}

/// The inspector has the other rows.
void ValueCard::showFew()
{
    const bool isErasure = !m_segments->erasure()->size()->label()->isHidden(); // It has rows of its own for them.
    for (const Number<Segment> &number : numbersOf<Segment>)
        if (SliderField *row = number.member ? m_segments->row(number.member) : nullptr)
            row->setVisible(!isErasure && (row == m_segments->diffusion() || row == m_segments->density()));
    m_segments->born()->setVisible(false);
    m_segments->rewet()->hide();
}

void ValueCard::openAt(QPoint global, std::optional<SegmentRef> at)
{
    m_at = at;
    m_strokes = m_editor.selection().strokes;
    const bool whole = m_editor.selection().segments.empty();
    const std::set<SegmentRef> &segments = m_editor.selection().segments;
    if (segments.size() > 1)
        m_at.reset(); // a run stays as it is
    else if (segments.size() == 1)
        m_at = *segments.begin();
    m_hint->showHint({});
    refresh();
    (whole ? m_whole : m_one)->setChecked(true);
    m_one->setVisible(m_at.has_value());
    m_whole->setVisible(m_at.has_value());
    constexpr QPoint beside(-18, -18); // the paint that was pointed at stays to be seen
    setMinimumWidth(cardWidth);
    NumberField *first = firstNumber();
    FloatingCard::openAt(global, beside, first);
    first->selectAll();
}

/// The first one that can be typed into.
NumberField *ValueCard::firstNumber() const
{
    const SliderField *field = m_width;
    if (!m_fill->isHidden())
        field = m_fill->row(&Fill::diffusion);
    else if (!m_segments->erasure()->size()->label()->isHidden())
        field = m_segments->erasure()->size();
    else if (!m_width->number()->isEnabled())
        field = m_segments->diffusion();
    return field->number();
}

void ValueCard::choose(bool whole)
{
    if (whole || !m_at)
        m_editor.document().setSelection({m_strokes, {}});
    else
        m_editor.document().setSelection({{m_at->stroke}, {*m_at}});
    refresh();
}

double ValueCard::widest(const Inspected &inspected) const
{
    double widest = 0;
    for (std::size_t i = 0; i < inspected.refs.size(); ++i)
        if (const auto seen = seenOf(inspected, i, m_editor.clock().time()))
            widest = std::max(widest, 2 * seen->width);
    return widest;
}

void ValueCard::setWidth(double width, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    const Inspected inspected = inspect(document);
    const double now = widest(inspected);
    const Microseconds time = m_editor.clock().time();
    Edit edit = changeStrokes(document, document.selection().strokes, [&](Stroke &stroke) {
        for (const SegmentRef &ref : inspected.refs) {
            if (ref.stroke != stroke.id)
                continue;
            Segment &segment = stroke.segments[std::size_t(ref.segment)];
            if (segment.takesPaint())
                continue;
            const std::optional<SeenWidth> seen = seenWidth(stroke, ref.segment, time);
            if (seen && (seen->width > 0 || now == 0)) // what has faded stays so beside what is seen
                setSeenWidth(segment, *seen, now > 0 ? seen->width * width / now : width / 2);
        }
    });
    m_editor.push(std::move(edit), tr("Change width"), entry);
}

void ValueCard::refresh()
{
    const Inspected inspected = inspect(m_editor.document());
    if (inspected.isEmpty()) {
        close();
        return;
    }
    const std::size_t count = inspected.strokes.size();
    const bool one = m_at && m_editor.selection().segments.size() == 1;
    const QString stroke = count == 1 ? titleOf(*inspected.strokes.front()) : tr("%Ln stroke(s)", nullptr, int(count));
    m_title->setText(one ? tr("%1, segment %2").arg(stroke).arg(m_at->segment + 1) : stroke);
    const bool isErasure = inspected.isErasure();
    const bool fillsAlone =
        !isErasure && std::ranges::all_of(inspected.strokes, [](const Stroke *s) { return isFillAlone(*s); });
    m_fill->setVisible(fillsAlone);
    m_segments->setVisible(!fillsAlone);
    m_width->setVisible(!fillsAlone && !isErasure);
    m_segments->refresh(inspected);
    m_fill->refresh(inspected);
    showFew();
    const double now = widest(inspected);
    m_width->setEnabled(now > 0);
    m_width->setValue(now > 0 ? std::optional(now) : std::nullopt);
}

} // namespace suffuse
