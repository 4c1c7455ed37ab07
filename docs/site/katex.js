// Formulas that Arithmatex has marked are drawn by KaTeX, on every page that the reader opens.
const draw = () => renderMathInElement(document.body, {
  delimiters: [{left: "\\[", right: "\\]", display: true}, {left: "\\(", right: "\\)", display: false}],
  throwOnError: false
});
document.addEventListener("DOMContentLoaded", draw);
