// Icon: the app's own pictures and the page's, by name, in the colour of the text beside them.
const drawings = {
    ...import.meta.glob<string>('../../../app/resources/icons/actions/*.svg', {
        query: '?raw',
        import: 'default',
        eager: true,
    }),
    ...import.meta.glob<string>('../icons/*.svg', { query: '?raw', import: 'default', eager: true }),
};

/** What is inside of each drawing's svg element. */
const icons = new Map(
    Object.entries(drawings).map(([path, svg]) => [
        path.replace(/^.*\/(?:skvalp-)?|(?:-symbolic)?\.svg$/g, ''),
        svg.slice(svg.indexOf('<g'), svg.lastIndexOf('</svg>')),
    ]),
);

export function hasIcon(name: string): boolean {
    return icons.has(name);
}

export function Icon({ name }: { name: string }) {
    return (
        <svg
            class="icon"
            viewBox="0 0 16 16"
            aria-hidden="true"
            dangerouslySetInnerHTML={{ __html: icons.get(name) ?? '' }}
        />
    );
}
