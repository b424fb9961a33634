#include "app/panels/inspector/inspector_panel.h"

#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/figures/figures_section.h"
#include "app/panels/inspector/fill_section.h"
#include "app/panels/inspector/group_section.h"
#include "app/panels/inspector/picture_section.h"
#include "app/panels/inspector/scroll_place.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/inspector/selection_summary.h"
#include "app/panels/inspector/stroke_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/panels/inspector/underlay_section.h"
#include "app/session/editor.h"
#include "app/widgets/habits/compare_button.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/slider_field.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/area/outline.h"
#include "undo/edits.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

InspectorPanel::InspectorPanel(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->setSpacing(0);
    m_scroll = new PanelScroll(this);
    m_hint = new HintLabel(this);
    outer->addWidget(m_scroll, 1);
    outer->addWidget(m_hint);

    auto *content = new QWidget;
    auto *pages = new QVBoxLayout(content);
    pages->setContentsMargins(8, 8, 8, 8);
    pages->setSpacing(0);
    m_selectionPage = new QWidget(content);
    m_canvasPage = new QWidget(content);
    pages->addWidget(m_selectionPage);
    pages->addWidget(m_canvasPage);
    pages->addStretch(1);

    auto *selection = new QVBoxLayout(m_selectionPage);
    selection->setContentsMargins(0, 0, 0, 0);
    selection->setSpacing(12);
    addHead(*selection);
    m_groups = new GroupSection(editor, m_selectionPage);
    m_picture = new PictureSection(editor, m_selectionPage);
    m_segments = new SegmentSection(editor, m_selectionPage);
    m_style = new StyleSection(editor, m_selectionPage);
    m_fill = new FillSection(editor, m_selectionPage);
    m_figures = new FiguresSection(editor, m_selectionPage);
    m_strokes = new StrokeSection(editor, m_selectionPage);
    for (QWidget *widget :
         std::initializer_list<QWidget *>{m_groups, m_picture, m_segments, m_style, m_fill, m_figures, m_strokes})
        selection->addWidget(widget);

    auto *canvas = new QVBoxLayout(m_canvasPage);
    canvas->setContentsMargins(0, 0, 0, 0);
    canvas->setSpacing(12);
    canvas->addWidget(
        quietLabel(tr("Nothing is selected. Click a stroke to see and change its values."), m_canvasPage));
    m_canvas = new CanvasSection(m_canvasPage);
    canvas->addWidget(m_canvas);
    m_underlay = new UnderlaySection(editor, m_canvasPage);
    canvas->addWidget(m_underlay);
    m_scroll->setWidget(content);
    m_place = new ScrollPlace(*m_scroll, {m_selectionPage, m_canvasPage});
    alignFieldLabels(*content);
    // Both pages ask for the same width, since the dock must not change with the selection.
    const int wider = std::max(m_selectionPage->minimumSizeHint().width(), m_canvasPage->minimumSizeHint().width());
    content->setMinimumWidth(wider + pages->contentsMargins().left() + pages->contentsMargins().right());

    connect(m_groups, &GroupSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_picture, &PictureSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_segments, &SegmentSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_style, &StyleSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_fill, &FillSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_strokes, &StrokeSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_canvas, &CanvasSection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_underlay, &UnderlaySection::refused, m_hint, &HintLabel::showRefusal);
    connect(m_canvas, &CanvasSection::edited, this,
            [this](const Canvas &value, const QString &text, ValueEntry *entry) {
                m_editor.push(setCanvas(m_editor.document(), value), text, entry);
            });
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &InspectorPanel::documentChanged);
    // A drag is about what was selected at the press. It ends when all know what is selected now.
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.selection)
            QMetaObject::invokeMethod(
                this, [this] { endDragsIn(*this); }, Qt::QueuedConnection);
    });
    refresh();
}

void InspectorPanel::addHead(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_summary = quietLabel(QString(), m_selectionPage);
    m_compare = new CompareButton(m_editor, m_selectionPage);
    m_alongButton = new QToolButton(m_selectionPage);
    m_alongButton->setText(tr("Along the Stroke…"));
    m_alongButton->setToolTip(tr("Sets a value along the stroke: constant, as a ramp, or drawn as a curve."));
    m_alongButton->setFocusPolicy(Qt::TabFocus);
    connect(m_alongButton, &QToolButton::clicked, this, &InspectorPanel::openAlong);
    for (QToolButton *button : {static_cast<QToolButton *>(m_compare), m_alongButton}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        row->addWidget(button, button == m_alongButton ? 3 : 2);
    }
    column.addWidget(m_summary);
    column.addLayout(row);
}

void InspectorPanel::openAlong()
{
    if (!m_along) {
        m_along = new AlongDialog(m_editor, this);
        emit alongOpening(m_along);
    }
    m_along->show();
    m_along->raise();
    m_along->activateWindow();
}

AlongDialog *InspectorPanel::along() const
{
    return m_along;
}

QSize InspectorPanel::sizeHint() const
{
    return {280, 480};
}

void InspectorPanel::documentChanged(const Change &change)
{
    // The stroke in hand is not inspected, and changes many times a second.
    if (change.strokes.empty() && !change.selection && !change.canvas && !change.reset)
        return;
    if (change.selection || change.reset) {
        m_hint->showHint({});
        for (SliderField *field : m_selectionPage->findChildren<SliderField *>())
            field->forgetChange();
    }
    if (isVisible())
        refresh();
    else
        m_stale = true;
}

void InspectorPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_stale)
        refresh();
}

void InspectorPanel::refresh()
{
    m_stale = false;
    const Inspected inspected = inspect(m_editor.document());
    showValues(inspected);
    m_place->restore();
}

void InspectorPanel::showValues(const Inspected &inspected)
{
    const Document &document = m_editor.document();
    m_selectionPage->setVisible(!inspected.isEmpty());
    m_canvasPage->setVisible(inspected.isEmpty());
    if (inspected.isEmpty()) {
        m_canvas->setResolution(m_editor.extras().resolution);
        m_canvas->setCanvas(document.painting()->canvas);
        m_underlay->refresh();
        return;
    }
    m_summary->setText(selectionSummary(inspected, !document.selection().segments.empty()));
    const bool isErasure = inspected.isErasure();
    putFirst(!isErasure && std::ranges::all_of(inspected.strokes, [](const Stroke *s) { return isFillAlone(*s); }));
    m_groups->refresh();
    m_picture->refresh(inspected);
    m_segments->refresh(inspected);
    // What takes paint away has neither a style nor a fill of its own: it weakens what is there.
    m_style->setVisible(!isErasure);
    m_fill->setVisible(!isErasure);
    m_style->refresh(inspected);
    m_fill->refresh(inspected);
    m_figures->refresh(inspected);
    m_strokes->refresh(inspected);
}

/// Of fills alone the fill stands first: what is meant of them. Else it stands below the values of the paint.
void InspectorPanel::putFirst(bool fill)
{
    auto *column = static_cast<QVBoxLayout *>(m_selectionPage->layout());
    if ((column->indexOf(m_fill) < column->indexOf(m_segments)) == fill)
        return;
    column->removeWidget(m_fill);
    column->insertWidget(fill ? column->indexOf(m_segments) : column->indexOf(m_style) + 1, m_fill);
    orderTabs();
}

/// Tab goes through the sections as they stand below each other, and not as they were made.
void InspectorPanel::orderTabs()
{
    const QLayout &column = *m_selectionPage->layout();
    const auto placeOf = [&](const QWidget *widget) {
        while (widget->parentWidget() != m_selectionPage)
            widget = widget->parentWidget();
        return column.indexOf(widget); // that of the head, which is a row, is −1
    };
    QWidgetList stops;
    for (QWidget *w = m_scroll->nextInFocusChain(); w != m_scroll; w = w->nextInFocusChain())
        if (m_selectionPage->isAncestorOf(w) && w->focusPolicy() != Qt::NoFocus && !w->focusProxy())
            stops << w;
    std::ranges::stable_sort(stops, {}, placeOf);
    for (qsizetype i = 1; i < stops.size(); ++i)
        setTabOrder(stops[i - 1], stops[i]);
}

} // namespace suffuse
