#include <grader/report/Markdown.h>

#include <grader/base/Utf8.h>

#include <cmark.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace ticker::report {
namespace {

using Node = std::unique_ptr<cmark_node, decltype(&cmark_node_free)>;

std::vector<cmark_node*> nodesOf(cmark_node* document) {
    const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> iterator{cmark_iter_new(document),
                                                                           cmark_iter_free};
    std::vector<cmark_node*> nodes;
    for (cmark_event_type event = cmark_iter_next(iterator.get()); event != CMARK_EVENT_DONE;
         event = cmark_iter_next(iterator.get()))
        if (event == CMARK_EVENT_ENTER) nodes.push_back(cmark_iter_get_node(iterator.get()));
    return nodes;
}

/// Turns markup into text: HTML, which could change the page or be invisible. Pictures become their
/// words, headings become paragraphs.
void makePlain(cmark_node* node) {
    const cmark_node_type type = cmark_node_get_type(node);
    if (type == CMARK_NODE_HTML_INLINE || type == CMARK_NODE_HTML_BLOCK) {
        cmark_node* text = cmark_node_new(CMARK_NODE_TEXT);
        std::string literal{cmark_node_get_literal(node)};
        while (literal.ends_with('\n'))
            literal.pop_back();
        cmark_node_set_literal(text, literal.c_str());
        cmark_node* whole = text;
        if (type == CMARK_NODE_HTML_BLOCK) {
            whole = cmark_node_new(CMARK_NODE_PARAGRAPH);
            cmark_node_append_child(whole, text);
        }
        cmark_node_insert_before(node, whole);
    } else if (type == CMARK_NODE_IMAGE) {
        while (cmark_node* child = cmark_node_first_child(node))
            cmark_node_insert_before(node, child);
    } else if (type == CMARK_NODE_HEADING) {
        cmark_node* paragraph = cmark_node_new(CMARK_NODE_PARAGRAPH);
        while (cmark_node* child = cmark_node_first_child(node))
            cmark_node_append_child(paragraph, child);
        cmark_node_insert_before(node, paragraph);
    } else {
        return;
    }
    cmark_node_free(node);
}

}  // namespace

std::string markdownHtml(std::string_view text) {
    const std::string clean = cleanText(text);
    const Node document{cmark_parse_document(clean.data(), clean.size(), CMARK_OPT_DEFAULT),
                        cmark_node_free};
    for (cmark_node* node : nodesOf(document.get()))
        makePlain(node);
    const std::unique_ptr<char, decltype(&std::free)> html{
        cmark_render_html(document.get(), CMARK_OPT_HARDBREAKS), std::free};
    return html.get();
}

}  // namespace ticker::report
