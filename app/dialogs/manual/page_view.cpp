#include "app/dialogs/manual/page_view.h"

#include "app/dialogs/manual/page_look.h"

#include <QApplication>
#include <QDesktopServices>
#include <QScrollBar>
#include <QTextBlock>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// Of a column, in heights of the font: about 80 letters.
constexpr double widest = 38;

} // namespace

PageView::PageView(QWidget *parent) : QTextBrowser(parent)
{
    setFrameShape(QFrame::NoFrame);
    setBackgroundRole(QPalette::Base); // beside the column, too
    setAutoFillBackground(true);
    setOpenLinks(false);
    setTextInteractionFlags(Qt::TextBrowserInteraction | Qt::TextSelectableByKeyboard);
    connect(this, &QTextBrowser::anchorClicked, this, &PageView::follow);
}

QFont PageView::pageFont() const
{
    QFont font = QApplication::font();
    font.setPointSizeF(QFontInfo(font).pointSizeF() * 1.06 * std::pow(1.1, m_zoom));
    return font;
}

void PageView::showPage(const ManualPage &page, const QStringList &words)
{
    m_page = page;
    setPage();
    verticalScrollBar()->setValue(0);
    mark(words);
}

void PageView::setAnew()
{
    const double scrolled = verticalScrollBar()->value() / double(std::max(verticalScrollBar()->maximum(), 1));
    setPage();
    verticalScrollBar()->setValue(int(scrolled * verticalScrollBar()->maximum()));
}

void PageView::zoomBy(int steps)
{
    m_zoom = steps == 0 ? 0 : std::clamp(m_zoom + steps, -4, 12);
    resizeEvent(nullptr);
    setAnew();
}

/// Each page is a document of its own: Qt 6.4 crashes when it reads Markdown into one that a view shows.
void PageView::setPage()
{
    setExtraSelections({});
    m_pictures = pictureRoom();
    QTextDocument *before = m_document;
    m_document = new QTextDocument(this); // which asks this view for its pictures
    m_document->setUndoRedoEnabled(false);
    m_document->setMarkdown(m_page.text, QTextDocument::MarkdownDialectGitHub);
    setPageLook(*m_document, pageFont(), palette(), m_pictures);
    setDocument(m_document);
    if (before) // Where this view is being shown, Qt is walking through its children, of which it is one.
        before->deleteLater();
    setAccessibleName(m_page.title);
}

int PageView::pictureRoom() const
{
    return viewport()->width() - int(2 * pageMargin(pageFont()));
}

/// Marks what was looked for; the first place is shown a quarter below the top.
void PageView::mark(const QStringList &words)
{
    QList<ExtraSelection> marks;
    QTextCursor first;
    QTextCharFormat format;
    format.setBackground(palette().highlight());
    format.setForeground(palette().highlightedText());
    for (const QString &word : words) {
        // “a” stands in nearly every word; a character of Chinese is a word of its own.
        constexpr char16_t firstOfChinese = 0x2e80;
        const bool isShort = word.size() < 3 && word.front() < firstOfChinese;
        const auto how = isShort ? QTextDocument::FindWholeWords : QTextDocument::FindFlags();
        for (QTextCursor at = document()->find(word, 0, how); !at.isNull(); at = document()->find(word, at, how)) {
            marks << ExtraSelection{at, format};
            if (first.isNull() || at.selectionStart() < first.selectionStart())
                first = at;
        }
    }
    setExtraSelections(marks);
    if (!first.isNull())
        verticalScrollBar()->setValue(cursorRect(first).top() + verticalScrollBar()->value() - viewport()->height() / 4);
}

void PageView::follow(const QUrl &link)
{
    const QString file = link.path();
    if (link.scheme().isEmpty() && file.endsWith(QLatin1String(".md")))
        emit pageWanted(file.chopped(3));
    else if (link.scheme().startsWith(QLatin1String("http")))
        QDesktopServices::openUrl(link);
}

/// A picture is made as small here as it is shown, since the document would leave out pixels.
QVariant PageView::loadResource(int type, const QUrl &name)
{
    if (type != QTextDocument::ImageResource)
        return {};
    QImage picture(pictureFile(name.path()));
    const QSizeF size = shownSize(picture.size(), m_pictures) * devicePixelRatioF();
    if (size.isEmpty())
        return {};
    picture = picture.scaled(size.toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    return picture;
}

void PageView::resizeEvent(QResizeEvent *event)
{
    const int room = width() - verticalScrollBar()->sizeHint().width();
    const int column = int(widest * QFontMetricsF(pageFont()).height());
    const int side = std::max((room - column) / 2, 0);
    setViewportMargins(side, 0, side, 0);
    if (event)
        QTextBrowser::resizeEvent(event);
    if (m_document && pictureRoom() != m_pictures)
        setAnew();
}

void PageView::wheelEvent(QWheelEvent *event)
{
    if (event->modifiers() == Qt::ControlModifier && event->angleDelta().y() != 0)
        zoomBy(event->angleDelta().y() > 0 ? 1 : -1);
    else
        QTextBrowser::wheelEvent(event);
}

} // namespace suffuse
