#include "app/panels/inspector/segment_section.h"

#include "app/panels/inspector/rows/erasure_rows.h"
#include "app/panels/inspector/rows/rewet_rows.h"
#include "app/session/editor.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/quantity.h"
#include "undo/edits.h"
#include "undo/time_edits.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse {

namespace {

FieldSpec bornSpec()
{
    return {.name = SegmentSection::tr("Born"),
            .toolTip =
                SegmentSection::tr("When the stroke, or what is selected of it, begins. All of that moves in time "
                                   "as one."),
            .display = timeDisplay(),
            .minimum = 0, // Edits keep a painting from beginning before this.
            .maximum = moment.greatest,
            .sliderMaximum = 10,
            .step = 0.1};
}

/// The times at which the selected segments of each stroke begin.
std::vector<Microseconds> beginsOf(const std::vector<InspectedSegment> &segments)
{
    std::vector<Microseconds> begins;
    const Stroke *stroke = nullptr;
    for (const InspectedSegment &s : segments) {
        if (s.stroke != stroke)
            begins.push_back(s.segment->born);
        stroke = s.stroke;
        begins.back() = std::min(begins.back(), s.segment->born);
    }
    return begins;
}

/// The same of what a selection means in a painting.
std::vector<Microseconds> beginsIn(const Painting &painting, const Selection &selection)
{
    std::vector<Microseconds> begins;
    beginAt(painting, selection, [&](Microseconds begin) {
        begins.push_back(begin);
        return begin;
    });
    return begins;
}

/// Whether all of it has moved by this time, or as far back as the beginning allows.
bool isMovedBy(const Painting &now, const Painting &then, const Selection &selection, Microseconds by)
{
    const std::vector<Microseconds> begins = beginsIn(now, selection), before = beginsIn(then, selection);
    if (begins.empty() || begins.size() != before.size())
        return false;
    const Microseconds moved = begins.front() - before.front();
    for (std::size_t i = 0; i < begins.size(); ++i)
        if (begins[i] - before[i] != moved)
            return false;
    return moved == by || (by < moved && std::ranges::min(begins) == 0);
}

const Number<Segment> &numberOfChannel(int channel)
{
    const std::array channels{&Colour::red, &Colour::yellow, &Colour::blue, &Colour::opacity};
    return numberOf(channels[std::size_t(channel)]);
}

/// A change that is shown is forgotten when the values are not what it made of them any more, nor what an undo or a
/// redo of it makes.
void forgetUnless(SliderField &row, const Number<Segment> &number, const Inspected &inspected)
{
    row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
        const auto valueOf = [&](const Segment &segment) { return number.of(segment); };
        return start && isChangedBy(*inspected.painting, *start, inspected.refs, valueOf, change);
    });
}

/// Shows the value that all segments have, or the change that all of them had.
void showCommon(SliderField &row, const Number<Segment> &number, const Inspected &inspected)
{
    forgetUnless(row, number, inspected);
    row.setValue(commonNumber(inspected.segments, [&](const InspectedSegment &s) { return number.of(*s.segment); }));
}

QString colourText(int channel)
{
    return channel == ColourRows::Opacity ? SegmentSection::tr("Change opacity") : SegmentSection::tr("Change colour");
}

} // namespace

SegmentSection::SegmentSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_title = sectionTitle(tr("Segments"), this);
    column->addWidget(m_title);
    auto *grid = addFieldGrid(*column);
    m_erasure = new ErasureRows(editor, *grid, this);
    connect(m_erasure, &ErasureRows::refused, this, &SegmentSection::refused);
    m_diffusion = addRow(specOf(Quantity::Diffusion), *grid, &Segment::diffusion, tr("Change diffusion"));
    m_density = addRow(specOf(Quantity::Density), *grid, &Segment::density, tr("Change density"));
    m_granulation = addRow(specOf(Quantity::Granulation), *grid, &Segment::granulation, tr("Change granulation"));
    m_maxAge = addRow(specOf(Quantity::MaxAge), *grid, &Segment::maxAge, tr("Change drying time"));
    addBorn(*grid);
    m_anisotropy = addRow(specOf(Quantity::Anisotropy), *grid, &Segment::anisotropyRatio, tr("Change anisotropy"));
    m_angle = addRow(specOf(Quantity::Angle), *grid, &Segment::anisotropyAngle, tr("Change angle"));

    std::vector<float Segment::*> shown;
    for (const auto &[member, row] : m_rows)
        shown.push_back(member);
    for (const Number<Segment> &number : otherNumbers(shown))
        addRow(specOf(number), *grid, number.member, tr("Change %1").arg(QLatin1String(number.name)));

    m_rewet = new RewetRows(editor, this);
    column->addWidget(m_rewet);

    auto *head = new QHBoxLayout;
    m_colourTitle = sectionTitle(tr("Colour"), this);
    head->addWidget(m_colourTitle, 1);
    m_swatch = new ColourSwatch(this);
    m_swatch->setAccessibleName(tr("Colour of the selection"));
    m_swatch->setToolTip(tr("Colour of the selection. Click: paint with it."));
    head->addWidget(m_swatch);
    column->addSpacing(8);
    column->addLayout(head);
    m_colour = new ColourRows(true, this);
    column->addWidget(m_colour);
    connect(m_colour, &ColourRows::edited, this, &SegmentSection::changeColour);
    connect(m_colour, &ColourRows::editedRelative, this, [this](int channel, const ValueMap &map) {
        changeEach([channel](Segment &s) -> float & { return ColourRows::channelOf(s.colour, channel); }, map,
                   colourText(channel));
    });
    connect(m_colour, &ColourRows::changed, this, [this](int channel, const ValueChange &change, ValueEntry *entry) {
        changeTogether(numberOfChannel(channel), change, colourText(channel), entry);
    });
    connect(m_colour, &ColourRows::refused, this, &SegmentSection::refused);
    connect(m_swatch, &ColourSwatch::clicked, this, &SegmentSection::takeCurrentColour);
}

void SegmentSection::addBorn(QGridLayout &grid)
{
    m_born = new SliderField(bornSpec(), grid, grid.rowCount(), this);
    connect(m_born, &SliderField::edited, this,
            [this](double value, ValueEntry *entry) { changeBorn([value](double) { return value; }, entry); });
    connect(m_born, &SliderField::editedRelative, this, [this](const ValueMap &map) { changeBorn(map, nullptr); });
    connect(m_born, &SliderField::changed, this, &SegmentSection::changeBornTogether);
    connect(m_born, &SliderField::refused, this, &SegmentSection::refused);
}

void SegmentSection::changeBorn(const ValueMap &map, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    bool possible = true;
    const auto mapped = [&](Microseconds begin) -> std::optional<Microseconds> {
        const std::optional<double> value = map(toSeconds(begin));
        possible = possible && value;
        return value ? std::optional(toMicroseconds(*value)) : std::nullopt;
    };
    Edit edit = beginAt(*document.painting(), document.selection(), mapped);
    if (possible)
        m_editor.push(std::move(edit), tr("Change birth"), entry);
    else
        refuse();
}

void SegmentSection::changeBornTogether(const ValueChange &change, ValueEntry *entry)
{
    const Document &document = m_editor.document();
    const std::vector<Microseconds> now = beginsIn(*document.painting(), document.selection()),
                                    then = beginsIn(*entry->start(document), document.selection());
    if (now.empty() || now.size() != then.size())
        return;
    // All of them move by the same time, so what is between them stays; none begins before the painting does.
    const Microseconds wished = toMicroseconds(change.amount) - (now.front() - then.front());
    const Microseconds by = std::max(wished, std::min<Microseconds>(0, -std::ranges::min(now)));
    m_editor.push(beginAt(*document.painting(), document.selection(), [by](Microseconds begin) { return begin + by; }),
                  tr("Change birth"), entry);
}

void SegmentSection::refuse()
{
    emit refused(tr("Not possible for all that is selected: a value would be out of range."));
}

SliderField *SegmentSection::addRow(const FieldSpec &spec, QGridLayout &grid, float Segment::*member,
                                    const QString &undoText)
{
    auto *field = new SliderField(spec, grid, grid.rowCount(), this);
    m_rows.emplace_back(member, field);
    connect(field, &SliderField::edited, this, [this, member, undoText](double value, ValueEntry *entry) {
        Document &document = m_editor.document();
        m_editor.push(changeSegments(document, targetSegments(document),
                                     [=](Segment &segment) { segment.*member = float(value); }),
                      undoText, entry);
    });
    connect(field, &SliderField::editedRelative, this, [this, member, undoText](const ValueMap &map) {
        changeEach([member](Segment &s) -> float & { return s.*member; }, map, undoText);
    });
    connect(field, &SliderField::changed, this, [this, member, undoText](const ValueChange &change, ValueEntry *entry) {
        changeTogether(numberOf(member), change, undoText, entry);
    });
    connect(field, &SliderField::refused, this, &SegmentSection::refused);
    return field;
}

SliderField *SegmentSection::row(float Segment::*member) const
{
    const auto at = std::ranges::find(m_rows, member, &std::pair<float Segment::*, SliderField *>::first);
    return at == m_rows.end() ? nullptr : at->second;
}

void SegmentSection::changeEach(const std::function<float &(Segment &)> &member, const ValueMap &map,
                                const QString &undoText)
{
    Document &document = m_editor.document();
    bool possible = true;
    Edit edit = changeSegments(document, targetSegments(document), [&](Segment &segment) {
        float &value = member(segment);
        const std::optional<double> mapped = map(double(value));
        possible = possible && mapped;
        value = float(mapped.value_or(value));
    });
    if (possible)
        m_editor.push(std::move(edit), undoText);
    else
        refuse();
}

void SegmentSection::changeTogether(const Number<Segment> &number, const ValueChange &change, const QString &undoText,
                                    ValueEntry *entry)
{
    Document &document = m_editor.document();
    m_editor.push(changeSegmentsSince(document, *entry->start(document), targetSegments(document),
                                      [&](Segment &now, const Segment &then) {
                                          number.of(now) = float(change.applied(double(number.of(then))));
                                      }),
                  undoText, entry);
}

void SegmentSection::changeColour(int channel, double value, ValueEntry *entry)
{
    Document &document = m_editor.document();
    m_editor.push(
        changeSegments(document, targetSegments(document),
                       [=](Segment &segment) { ColourRows::channelOf(segment.colour, channel) = float(value); }),
        colourText(channel), entry);
}

void SegmentSection::takeCurrentColour()
{
    if (m_swatch->colour())
        m_editor.setColour(*m_swatch->colour());
}

void SegmentSection::showBorn(const Inspected &inspected)
{
    const std::vector<Microseconds> begins = beginsOf(inspected.segments);
    m_born->keepChange([&, start = m_born->entry().start()](const ValueChange &change) {
        return start && isMovedBy(*inspected.painting, *start, m_editor.selection(), toMicroseconds(change.amount));
    });
    if (!begins.empty() && !m_born->slider()->isSliderDown()) // The scale of the slider must not change during a drag.
        m_born->setSliderRange(0, 10 * (1 + std::floor(toSeconds(std::ranges::max(begins)) / 10)));
    m_born->setValue(commonNumber(begins, [](Microseconds begin) { return toSeconds(begin); }));
}

/// An erasure has a strength and a size in place of φ and D; it has neither grain nor colour.
void SegmentSection::nameForErasure(bool erasure)
{
    if (std::exchange(m_namesErasure, erasure) == erasure)
        return;
    m_title->setText(erasure ? tr("Erasure") : tr("Segments"));
    m_diffusion->setVisible(!erasure);
    m_density->setVisible(!erasure);
    m_granulation->setVisible(!erasure);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_colourTitle, m_swatch, m_colour})
        widget->setVisible(!erasure);
}

void SegmentSection::refresh(const Inspected &inspected)
{
    const auto &segments = inspected.segments;
    for (const auto &[member, row] : m_rows)
        showCommon(*row, numberOf(member), inspected);
    showBorn(inspected);
    nameForErasure(inspected.isErasure());
    m_erasure->refresh(inspected);
    m_angle->setEnabled(std::any_of(segments.begin(), segments.end(),
                                    [](const InspectedSegment &s) { return !s.segment->isIsotropic(); }));

    m_rewet->refresh(inspected);

    std::array<std::optional<double>, 4> channels;
    for (int channel = 0; channel < 4; ++channel)
        forgetUnless(*m_colour->row(channel), numberOfChannel(channel), inspected);
    for (int channel = 0; channel < 4; ++channel)
        channels[std::size_t(channel)] = commonNumber(segments, [channel](const InspectedSegment &s) {
            return ColourRows::channelOf(s.segment->colour, channel);
        });
    m_colour->setColour(channels, segments.empty() ? Colour{} : segments.front().segment->colour);
    m_swatch->setColour(commonValue(segments, [](const InspectedSegment &s) { return s.segment->colour; }));
}

} // namespace suffuse
