#include "app/panels/inspector/stroke_section.h"

#include "app/panels/inspector/rows/combo_row.h"
#include "app/session/editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/painting/editable.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {
/// A change that is shown is forgotten when β is not what it made of it any more.
void forgetBetaUnless(SliderField &row, const Painting &now, const std::vector<const Stroke *> &strokes)
{
    const Locks isLocked(now.groups);
    row.keepChange([&, start = row.entry().start()](const ValueChange &change) {
        return std::ranges::all_of(strokes, [&](const Stroke *stroke) {
            const StrokePtr then = start ? start->find(stroke->id) : nullptr;
            return then && (isLocked(*stroke) || stroke->mix.beta == float(change.applied(double(then->mix.beta))));
        });
    });
}
} // namespace

StrokeSection::StrokeSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(sectionTitle(tr("Strokes"), this));
    QGridLayout *grid = addFieldGrid(*column);

    addName(*grid);
    addMixing(*grid);
    m_washNote = quietLabel(tr("The mixing of the wash is seen in place of this one."), this);
    column->addWidget(m_washNote);
}

void StrokeSection::addName(QGridLayout &grid)
{
    auto *nameLabel = new QLabel(tr("Name"), this);
    m_name = new EntryField(this);
    m_name->setAccessibleName(tr("Name"));
    m_name->setToolTip(tr("Name of the selected strokes, as the list of strokes shows it."));
    nameLabel->setBuddy(m_name);
    grid.addWidget(nameLabel, 0, 0);
    grid.addWidget(m_name, 0, 1, 1, 2);
    connect(m_name, &EntryField::typed, this, [this](const QString &text) {
        Document &document = m_editor.document();
        m_editor.push(changeStrokes(document, document.selection().strokes, [&](Stroke &s) { s.name = text; }),
                      tr("Rename stroke"));
    });
}

void StrokeSection::addMixing(QGridLayout &grid)
{
    m_mode = ComboRow::add(grid, 1, tr("Mixing"),
                           tr("How the paint mixes with what lies below it: it covers, or pigments add up."),
                           mixingNames(), this)
                 .box;
    connect(m_mode, &QComboBox::activated, this, [this](int index) { chooseMode(MixMode(index)); });

    m_beta = new SliderField(specOf(Quantity::Beta), grid, 2, this);
    connect(m_beta, &SliderField::refused, this, &StrokeSection::refused);
    connect(m_beta, &SliderField::editedRelative, this, [this](const ValueMap &map) {
        Document &document = m_editor.document();
        bool possible = true;
        Edit edit = changeStrokes(document, document.selection().strokes, [&](Stroke &s) {
            if (s.mix.mode != MixMode::Beta)
                return;
            const std::optional<double> mapped = map(double(s.mix.beta));
            possible = possible && mapped;
            s.mix.beta = float(mapped.value_or(s.mix.beta));
        });
        if (possible)
            m_editor.push(std::move(edit), tr("Change pigment mixing"));
        else
            emit refused(tr("Not possible for all that is selected: a value would be out of range."));
    });
    connect(m_beta, &SliderField::changed, this, [this](const ValueChange &change, ValueEntry *entry) {
        Document &document = m_editor.document();
        const PaintingPtr start = entry->start(document);
        m_editor.push(changeStrokes(document, document.selection().strokes,
                                    [&](Stroke &s) {
                                        const StrokePtr then = start->find(s.id);
                                        if (then && s.mix.mode == MixMode::Beta)
                                            s.mix.beta = float(change.applied(double(then->mix.beta)));
                                    }),
                      tr("Change pigment mixing"), entry);
    });
    connect(m_beta, &SliderField::edited, this, [this](double value, ValueEntry *entry) {
        Document &document = m_editor.document();
        m_editor.push(changeStrokes(document, document.selection().strokes,
                                    [=](Stroke &s) {
                                        if (s.mix.mode == MixMode::Beta)
                                            s.mix.beta = float(value);
                                    }),
                      tr("Change pigment mixing"), entry);
    });
}

Mix StrokeSection::usualMix(MixMode mode)
{
    return {mode, mode == MixMode::Beta ? float(specOf(Quantity::Beta).defaultValue) : 0};
}

void StrokeSection::chooseMode(MixMode mode)
{
    Document &document = m_editor.document();
    m_editor.push(changeStrokes(document, document.selection().strokes,
                                [=](Stroke &s) {
                                    if (s.mix.mode != mode)
                                        s.mix = usualMix(mode);
                                }),
                  tr("Change mixing"));
    refresh(inspect(document));
}

void StrokeSection::refresh(const Inspected &inspected)
{
    const auto &strokes = inspected.strokes;
    const auto name = commonValue(strokes, [](const Stroke *s) { return s->name; });
    m_name->showText(name.value_or(QString()));
    m_name->setPlaceholderText(name ? tr("unnamed") : QStringLiteral("—"));
    const auto mode = commonValue(strokes, [](const Stroke *s) { return s->mix.mode; });
    m_mode->setCurrentIndex(mode ? int(*mode) : -1);
    m_washNote->setVisible(areInWashes(inspected));
    std::vector<const Stroke *> pigments;
    std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(pigments),
                 [](const Stroke *s) { return s->mix.mode == MixMode::Beta; });
    m_beta->setEnabled(!pigments.empty());
    forgetBetaUnless(*m_beta, *inspected.painting, pigments);
    m_beta->setValue(commonNumber(pigments, [](const Stroke *s) { return s->mix.beta; }));
}

} // namespace suffuse
