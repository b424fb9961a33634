#include "app/tools/text/text_values.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/tools/text/text_row.h"
#include "app/tools/text/text_style.h"
#include "model/shaping/baseline_curve.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"

namespace suffuse {

namespace {

double seenScale(const Affine &map)
{
    return std::sqrt(std::abs(map.determinant()));
}

/// The same text with a place that does not scale, so that its size is what is seen.
Text atItsSize(Text text)
{
    const double scale = seenScale(text.place);
    if (!(scale > 0) || scale == 1)
        return text;
    text.size *= scale;
    for (Cubic &curve : text.curve)
        for (Point &p : curve.p)
            p = scale * p;
    if (text.follows != 0)
        text.followMap = Affine{scale, 0, 0, scale, {}} * text.followMap;
    text.place = text.place * Affine{1 / scale, 0, 0, 1 / scale, {}};
    return text;
}

} // namespace

TextValues::TextValues(CanvasWidget &canvas, TextEntry &entry, QObject *parent)
    : QObject(parent), m_canvas(canvas), m_editor(canvas.editor()), m_entry(entry), m_style(storedTextStyle())
{
    connect(&m_editor.laterChanges(), &LaterChanges::changed, this, [this](const Change &change) {
        if (change.selection || change.canvas || change.texts || change.reset)
            showRow();
    });
}

QWidget *TextValues::options()
{
    if (m_row)
        return m_row;
    m_row = new TextRow;
    connect(m_row, &TextRow::changed, this, &TextValues::changeValues);
    connect(m_row, &TextRow::bendWanted, this, &TextValues::bend);
    connect(m_row, &TextRow::straightenWanted, this, &TextValues::straighten);
    connect(m_row, &TextRow::done, this, [this] {
        if (m_entry.isOpen())
            m_canvas.setFocus();
    });
    showRow();
    return m_row;
}

void TextValues::showRow()
{
    if (!m_row)
        return;
    const Document &document = m_editor.unsettled();
    const SharedText selected = textOf(*document.painting(), selectedText(document));
    const Text &shown = m_entry.isOpen() ? m_entry.text() : selected ? *selected : m_style;
    const bool canBend =
        std::ranges::any_of(m_entry.isOpen() ? m_chosen : document.selection().strokes, [&](StrokeId id) {
            const StrokePtr stroke = document.painting()->find(id);
            return stroke && !textAround(*document.painting(), *stroke);
        });
    m_row->show(atItsSize(shown), !m_entry.isOpen() || m_entry.laid().hasFamily, canBend);
}

void TextValues::changeValues(const TextRow::Change &how)
{
    const auto change = [&how](Text &text) {
        text = atItsSize(std::move(text));
        how(text);
    };
    how(m_style);
    storeTextStyle(m_style);
    if (m_entry.isOpen()) {
        m_entry.change(change);
        return;
    }
    Document &document = m_editor.document();
    const GroupId group = selectedText(document);
    const SharedText text = textOf(*document.painting(), group);
    if (text && isTextLocked(*document.painting(), group)) {
        emit locked();
    } else if (text) {
        Text next = *text;
        change(next);
        const LaidText before = m_layout.lay(*text), after = m_layout.lay(next);
        const TextChange letters{{}, letterWith(m_editor.brush(), next.size, m_editor.clock().time()), true};
        m_editor.push(setText(document, group, next, &before, after, letters), tr("Change text"), &m_values);
    }
    showRow();
}

StrokePtr TextValues::selectedStroke() const
{
    const Painting &painting = *m_editor.document().painting();
    const std::set<StrokeId> &among = m_entry.isOpen() ? m_chosen : m_editor.selection().strokes;
    StrokePtr topmost;
    for (const StrokePtr &stroke : painting.strokes)
        if (among.contains(stroke->id) && !textAround(painting, *stroke))
            topmost = stroke;
    return topmost;
}

void TextValues::bend()
{
    const StrokePtr stroke = selectedStroke();
    if (stroke && !baselineOf(*stroke).empty())
        setOnCurve(baselineOf(*stroke), stroke->id);
}

void TextValues::straighten()
{
    setOnCurve({}, 0);
}

/// Sets the text in hand, or the selected one, along the curve of a stroke, in canvas units; where there is none, a new
/// text begins there. An empty curve: it becomes straight where its curve began.
void TextValues::setOnCurve(const std::vector<Cubic> &curve, StrokeId stroke)
{
    const auto how = [&](Text &text) {
        text.follows = stroke;
        text.followMap = {};
        if (curve.empty()) {
            if (!text.curve.empty())
                text.place.offset = text.place(text.curve.front().p[0]);
            text.curve.clear();
            return;
        }
        text = atItsSize(std::move(text));
        text.place = text.followMap = {};
        text.curve = curve;
    };
    if (!m_entry.isOpen()) {
        const Painting &painting = *m_editor.document().painting();
        GroupId group = 0;
        for (const StrokePtr &stroke : painting.strokes)
            if (m_editor.selection().strokes.contains(stroke->id))
                if (const GroupId text = textAround(painting, *stroke))
                    group = text;
        m_chosen = m_editor.selection().strokes;
        if (group) {
            m_entry.open(group);
        } else if (!curve.empty()) {
            Text begun = m_style;
            begun.vertical = false;
            begun.curve = curve;
            begun.follows = stroke;
            m_entry.begin(begun);
            m_canvas.setFocus();
            return;
        }
    }
    if (m_entry.isOpen())
        m_entry.change(how);
    m_canvas.setFocus();
}

} // namespace suffuse
