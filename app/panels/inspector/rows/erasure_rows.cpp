#include "app/panels/inspector/rows/erasure_rows.h"

#include "app/session/editor.h"
#include "app/widgets/numbers/quantity.h"
#include "model/paint/derived_figures.h"
#include "model/shaping/erasing/erasure_size.h"

#include <QComboBox>
#include <QGridLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse {

namespace {

enum Kind { Fades, Lifts }; // the choices of the list

/// The share that a segment takes, in steps that nobody sees, so that sums of them are equal numbers again.
float shownShare(const Segment &segment)
{
    constexpr double steps = 10'000;
    return float(std::round(takenShare(segment) * steps) / steps);
}

/// To as many digits as float32 has room for.
double toFiveDigits(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-30))) - 4);
    return std::round(value / unit) * unit;
}

/// Those of all strokes of which segments are meant, which may have been changed by an edit.
ErasureSizes sizesIn(const Painting &painting, const std::vector<SegmentRef> &refs, const Edit &edit = {})
{
    ErasureSizes sizes;
    StrokeId last = 0;
    for (const SegmentRef &ref : refs) {
        if (std::exchange(last, ref.stroke) == ref.stroke)
            continue;
        const auto changed = edit.strokes.find(ref.stroke);
        if (const StrokePtr stroke = changed == edit.strokes.end() ? painting.find(ref.stroke) : changed->second)
            sizes.add(*stroke);
    }
    return sizes;
}

FieldSpec erasureSizeSpec()
{
    return {.name = ErasureRows::tr("Size"),
            .toolTip = ErasureRows::tr("The diameter of the eraser, if its softness was the usual one."),
            .display = lengthDisplay(),
            .minimum = 1e-6,
            .maximum = 2e5,
            .sliderMinimum = 0.5,
            .sliderMaximum = 500,
            .logarithmic = true,
            .defaultValue = 20};
}

FieldSpec takenDensitySpec()
{
    return {.name = ErasureRows::tr("Density taken"),
            .toolTip = ErasureRows::tr("The density that it takes away in its middle: paint that is thinner is gone "
                                       "there."),
            .maximum = 1e6,
            .sliderMinimum = 0.01,
            .sliderMaximum = 1000,
            .logarithmic = true,
            .defaultValue = 1};
}

} // namespace

ErasureRows::ErasureRows(Editor &editor, QGridLayout &grid, QWidget *parent) : QObject(parent), m_editor(editor)
{
    m_kind = ComboRow::add(grid, grid.rowCount(), tr("Kind"),
                           tr("Fade makes paint paler; Lift takes its density away, so that edges draw in."),
                           {tr("Fade"), tr("Lift")}, parent);
    connect(m_kind.box, &QComboBox::activated, this, [this](int index) { setFade(index == Fades); });
    m_size = addRow(erasureSizeSpec(), grid, &ErasureRows::setSizes, tr("Change size"), parent);
    const FieldSpec share = shareSpec(tr("Strength"), tr("The share of the paint that it takes in its middle."), 0.5);
    m_share = addRow(share, grid, &ErasureRows::setShares, tr("Change strength"), parent);
    m_taken = addRow(takenDensitySpec(), grid, &ErasureRows::setTaken, tr("Change strength"), parent);
}

SliderField *ErasureRows::addRow(const FieldSpec &spec, QGridLayout &grid, Setter set, const QString &undoText,
                                 QWidget *parent)
{
    auto *row = new SliderField(spec, grid, grid.rowCount(), parent);
    connect(row, &SliderField::edited, this, [this, set, undoText](double value, ValueEntry *entry) {
        const PaintingPtr painting = m_editor.document().painting();
        m_editor.push((this->*set)(*painting, [value](double) { return value; }), undoText, entry);
    });
    connect(row, &SliderField::editedRelative, this, [this, set, undoText](const ValueMap &map) {
        bool possible = true;
        const PaintingPtr painting = m_editor.document().painting();
        Edit edit = (this->*set)(*painting, [&](double value) {
            const std::optional<double> mapped = map(value);
            possible = possible && mapped;
            return mapped;
        });
        if (possible)
            m_editor.push(std::move(edit), undoText);
        else
            emit refused(tr("Not possible for all that is selected: a value would be out of range."));
    });
    connect(row, &SliderField::changed, this, [this, set, undoText](const ValueChange &change, ValueEntry *entry) {
        const PaintingPtr start = entry->start(m_editor.document());
        m_editor.push((this->*set)(*start, [change](double value) { return change.applied(value); }), undoText, entry);
    });
    connect(row, &SliderField::refused, this, &ErasureRows::refused);
    return row;
}

void ErasureRows::setFade(bool fade)
{
    Document &document = m_editor.document();
    m_editor.push(changeSegments(document, targetSegments(document),
                                 [fade](Segment &segment) {
                                     if (segment.takesPaint())
                                         segment.fade = fade, segment.lift = !fade;
                                 }),
                  tr("Change kind of erasure"));
}

Edit ErasureRows::setSizes(const Painting &from, const ValueMap &map)
{
    const Document &document = m_editor.document();
    const std::vector<SegmentRef> targets = targetSegments(document);
    const ErasureSizes sizes = sizesIn(from, targets);
    return changeSegmentsSince(document, from, targets, [&](Segment &now, const Segment &then) {
        const double was = sizes.of(then);
        now.diffusion = then.diffusion;
        now.density = then.density;
        if (const std::optional<double> size = map(was); size && was > 0)
            widenErasure(now, *size / was);
    });
}

/// What is taken has a part in how large the eraser was; that stays.
Edit ErasureRows::setShares(const Painting &from, const ValueMap &map)
{
    const Document &document = m_editor.document();
    const std::vector<SegmentRef> targets = targetSegments(document);
    const auto take = [&map](Segment &now, const Segment &then) {
        now.diffusion = then.diffusion;
        now.density = then.density;
        if (const std::optional<double> share = map(double(shownShare(then))))
            setTakenShare(now, *share);
    };
    const ErasureSizes before = sizesIn(from, targets);
    const ErasureSizes after = sizesIn(from, targets, changeSegmentsSince(document, from, targets, take));
    return changeSegmentsSince(document, from, targets, [&](Segment &now, const Segment &then) {
        take(now, then);
        widenErasure(now, before.of(then) / after.of(now));
    });
}

Edit ErasureRows::setTaken(const Painting &from, const ValueMap &map)
{
    const Document &document = m_editor.document();
    return changeSegmentsSince(document, from, targetSegments(document), [&map](Segment &now, const Segment &then) {
        const double spread = erasureSpread(then);
        if (const std::optional<double> peak = map(peakDensity(then.density, spread)))
            now.density = float(std::min(densityOfPeak(*peak, spread), 1e12));
    });
}

void ErasureRows::refresh(const Inspected &inspected)
{
    const auto &segments = inspected.segments;
    const auto all = [&](bool Segment::*flag) {
        return std::ranges::all_of(segments, [flag](const InspectedSegment &s) { return s.segment->*flag; });
    };
    const bool erasure = inspected.isErasure(), fades = erasure && all(&Segment::fade);
    m_kind.setVisible(erasure);
    m_size->setVisible(erasure);
    m_share->setVisible(fades);
    m_taken->setVisible(erasure && !fades);
    if (!erasure)
        return;
    m_kind.box->setCurrentIndex(fades ? Fades : all(&Segment::lift) ? Lifts : -1);
    const auto keep = [&inspected](SliderField &row, const auto &valueOf, const auto &changeOf) {
        row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
            return start && isChangedBy(*inspected.painting, *start, inspected.refs, valueOf, changeOf(change));
        });
    };
    const auto same = [](const ValueChange &change) { return change; };
    // D goes with the square of the size.
    const auto ofDiffusion = [](const ValueChange &change) {
        return ValueChange{change.kind, change.amount * change.amount, 0,
                           numberOf(Quantity::Diffusion).traits.domain.greatest};
    };
    keep(
        *m_size, [](const Segment &segment) { return segment.diffusion; }, ofDiffusion);
    keep(*m_share, shownShare, same);
    keep(
        *m_taken, [](const Segment &segment) { return segment.density; }, same);
    const ErasureSizes sizes = sizesIn(*inspected.painting, inspected.refs);
    m_size->setValue(
        commonNumber(segments, [&](const InspectedSegment &s) { return toFiveDigits(sizes.of(*s.segment)); }));
    m_share->setValue(commonNumber(segments, [](const InspectedSegment &s) { return shownShare(*s.segment); }));
    m_taken->setValue(commonNumber(segments, [](const InspectedSegment &s) {
        return toFiveDigits(peakDensity(s.segment->density, erasureSpread(*s.segment)));
    }));
}

} // namespace suffuse
