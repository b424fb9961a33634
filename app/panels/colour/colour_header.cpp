#include "app/panels/colour/colour_header.h"

#include "app/session/colour/colour_target.h"
#include "app/session/editor.h"
#include "app/widgets/look/icons.h"
#include "model/colour/colour_shift.h"
#include "undo/colour_edits.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace suffuse {

ColourHeader::ColourHeader(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 0);
    row->setSpacing(2);
    m_brush = addChoice("brush", tr("Colour of the brush"), tr("Shows and changes the colour that is painted with"));
    m_selection = addChoice("select", tr("Colour of what is selected"),
                            tr("Shows and changes the colour of what is selected; it keeps its opacity"));
    m_title = new QLabel(this);
    m_title->setMinimumWidth(40);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addSpacing(4);
    row->addWidget(m_title, 1);
    m_mode = new QComboBox(this);
    m_mode->addItem(tr("Set"));
    m_mode->addItem(tr("Shift"));
    m_mode->setAccessibleName(tr("Several colours"));
    m_mode->setToolTip(tr("Set: all colours become the same.\nShift: all change as the shown one does, and keep their "
                          "differences."));
    row->addWidget(m_mode);
    m_apply = new QToolButton(this);
    m_apply->setIcon(icon("ok"));
    m_apply->setAutoRaise(true);
    m_apply->setFocusPolicy(Qt::TabFocus);
    m_apply->setAccessibleName(tr("Apply to selection"));
    m_apply->setToolTip(tr("Apply to selection: gives the selected segments the brush's colour. They keep their "
                           "opacity."));
    row->addWidget(m_apply);
    ColourTarget &target = editor.colourTarget();
    connect(m_brush, &QToolButton::clicked, this, [&target] { target.choose(ColourTarget::Kind::Brush); });
    connect(m_selection, &QToolButton::clicked, this, [&target] { target.choose(ColourTarget::Kind::Selection); });
    connect(m_mode, &QComboBox::activated, this, [&target](int index) { target.setMode(ColourTarget::Mode(index)); });
    connect(m_apply, &QToolButton::clicked, this, &ColourHeader::applyToSelection);
    connect(&target, &ColourTarget::changed, this, &ColourHeader::refresh);
    refresh();
}

QToolButton *ColourHeader::addChoice(const char *name, const QString &text, const QString &tip)
{
    auto *button = new QToolButton(this);
    button->setIcon(icon(name));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    layout()->addWidget(button);
    return button;
}

void ColourHeader::refresh()
{
    const ColourTarget &target = m_editor.colourTarget();
    const ColourTarget::Kind kind = target.kind();
    m_brush->setChecked(kind == ColourTarget::Kind::Brush);
    m_selection->setChecked(kind == ColourTarget::Kind::Selection);
    m_selection->setEnabled(target.canBeSelection());
    m_mode->setVisible(kind == ColourTarget::Kind::Selection && target.selected().several);
    m_mode->setCurrentIndex(int(target.mode()));
    m_apply->setVisible(kind == ColourTarget::Kind::Brush);
    m_apply->setEnabled(target.canBeSelection());
    m_text = target.title();
    showText();
}

void ColourHeader::showText()
{
    const QString fitting = m_title->fontMetrics().elidedText(m_text, Qt::ElideRight, m_title->width());
    m_title->setText(fitting);
    m_title->setToolTip(fitting == m_text ? QString() : m_text);
}

void ColourHeader::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    layout()->activate(); // the title has its width first
    showText();
}

void ColourHeader::applyToSelection()
{
    const Document &document = m_editor.document();
    if (document.selection().isEmpty())
        return;
    const Colour colour = m_editor.brush().colour;
    m_editor.push(recolour(document, partsToColour(*document.painting(), document.selection()),
                           [&](const Colour &each) { return withOpacity(colour, each.opacity); }),
                  tr("Apply colour"));
}

} // namespace suffuse
