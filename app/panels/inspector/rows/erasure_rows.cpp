#include "app/panels/inspector/rows/erasure_rows.h"

#include "app/session/editor.h"
#include "app/widgets/numbers/quantity.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/paint/derived_figures.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QGridLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

enum Kind { Fades, Lifts }; // the choices of the list

/// The share that a segment takes, in steps that nobody sees, so that sums of them are equal numbers again.
float shownShare(const Segment &segment)
{
    constexpr double steps = 10'000;
    return float(std::round(takenShare(segment) * steps) / steps);
}

} // namespace

ErasureRows::ErasureRows(Editor &editor, QGridLayout &grid, QWidget *parent) : QObject(parent), m_editor(editor)
{
    m_kind = ComboRow::add(grid, grid.rowCount(), tr("Kind"),
                           tr("Fade makes paint paler; Lift takes its density away, so that edges draw in."),
                           {tr("Fade"), tr("Lift")}, parent);
    connect(m_kind.box, &QComboBox::activated, this, [this](int index) { setFade(index == Fades); });
    m_share = new SliderField(shareSpec(tr("Takes"), tr("The share of the paint that it takes in its middle."), 0.5),
                              grid, grid.rowCount(), parent);
    connect(m_share, &SliderField::edited, this, &ErasureRows::setShare);
    connect(m_share, &SliderField::editedRelative, this, [this](const ValueMap &map) {
        bool possible = true;
        Edit edit = changeSegments(m_editor.document(), targetSegments(m_editor.document()), [&](Segment &segment) {
            const std::optional<double> share = map(double(shownShare(segment)));
            possible = possible && share;
            if (share)
                setTakenShare(segment, *share);
        });
        if (possible)
            m_editor.push(std::move(edit), tr("Change strength"));
        else
            emit refused(tr("Not possible for all that is selected: a value would be out of range."));
    });
    connect(m_share, &SliderField::changed, this, &ErasureRows::changeShares);
    connect(m_share, &SliderField::refused, this, &ErasureRows::refused);
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

void ErasureRows::setShare(double share, ValueEntry *entry)
{
    Document &document = m_editor.document();
    m_editor.push(changeSegments(document, targetSegments(document),
                                 [share](Segment &segment) { setTakenShare(segment, share); }),
                  tr("Change strength"), entry);
}

void ErasureRows::changeShares(const ValueChange &change, ValueEntry *entry)
{
    Document &document = m_editor.document();
    m_editor.push(changeSegmentsSince(document, *entry->start(document), targetSegments(document),
                                      [&](Segment &now, const Segment &then) {
                                          setTakenShare(now, change.applied(double(shownShare(then))));
                                      }),
                  tr("Change strength"), entry);
}

bool ErasureRows::refresh(const Inspected &inspected)
{
    const auto &segments = inspected.segments;
    const auto all = [&](bool Segment::*flag) {
        return std::ranges::all_of(segments, [flag](const InspectedSegment &s) { return s.segment->*flag; });
    };
    const bool fades = all(&Segment::fade), lifts = all(&Segment::lift);
    m_kind.setVisible(std::ranges::all_of(segments, [](const InspectedSegment &s) { return s.segment->takesPaint(); }));
    m_kind.box->setCurrentIndex(fades ? Fades : lifts ? Lifts : -1);
    m_share->setVisible(fades);
    if (!fades)
        return false;
    m_share->keepChange([&, start = m_share->entry().start()](const ValueChange &change) {
        return start && isChangedBy(*inspected.painting, *start, inspected.refs, shownShare, change);
    });
    m_share->setValue(commonNumber(segments, [](const InspectedSegment &s) { return shownShare(*s.segment); }));
    return true;
}

} // namespace suffuse
