// Plot: curves over time or another quantity, by uPlot. Invariant: what theory says is dashed; what was
// measured is a line or points, told apart without colours, too.
import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Curve } from '../simulation/protocol';
import { short } from './numbers';
import { tableOf } from './table';
import { language } from './words';

/** As in the app: told apart by people who see colours differently, too (Okabe and Ito). */
const colours = ['#56b4e9', '#e69f00', '#00b98a', '#f0e442', '#cc79a7', '#d55e00'];
/** The same for a light ground. */
const deeper = ['#0072b2', '#a86400', '#00795a', '#7a7000', '#a04a7c', '#b04a00'];
const HEIGHT = 240;

interface PlotProps {
    xLabel: string;
    yLabel: string;
    curves: Curve[];
    name: string;
}

function property(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function seriesOf(curve: Curve, index: number): uPlot.Series {
    const light = document.documentElement.dataset.palette === 'light';
    const stroke = (light ? deeper : colours)[index % colours.length];
    const dots = curve.style === 'dots' || curve.style === 'rings';
    return {
        label: curve.label,
        stroke,
        width: dots ? 0 : 2,
        dash: curve.style === 'theory' ? [8, 6] : undefined,
        points: { show: dots, size: 7, width: 2, fill: curve.style === 'rings' ? 'transparent' : stroke },
        paths: dots ? () => null : undefined,
    };
}

function optionsOf({ xLabel, yLabel, curves }: PlotProps, width: number): uPlot.Options {
    const axis = {
        stroke: property('--text'),
        grid: { stroke: property('--line'), width: 1 },
        ticks: { stroke: property('--line') },
        font: '14px system-ui',
        labelFont: '14px system-ui',
        labelSize: 24,
        values: (_plot: uPlot, values: number[]) => values.map((value) => short(value, 6)),
    };
    return {
        width,
        height: HEIGHT,
        scales: { x: { time: false } },
        legend: { live: false },
        cursor: { drag: { x: false, y: false } },
        axes: [
            { ...axis, label: xLabel },
            { ...axis, label: yLabel, size: 64 },
        ],
        series: [{ label: xLabel }, ...curves.map(seriesOf)],
    };
}

export function Plot(props: PlotProps) {
    const holder = useRef<HTMLDivElement>(null);
    const plot = useRef<uPlot | null>(null);
    const shape = [props.xLabel, props.yLabel, ...props.curves.map((c) => c.label + c.style), language.value].join();
    useEffect(() => {
        const element = holder.current!;
        const made = new uPlot(optionsOf(props, element.clientWidth), tableOf(props.curves), element);
        const observer = new ResizeObserver(() => made.setSize({ width: element.clientWidth, height: HEIGHT }));
        observer.observe(element);
        plot.current = made;
        return () => {
            observer.disconnect();
            made.destroy();
        };
    }, [shape]);
    useEffect(() => plot.current?.setData(tableOf(props.curves)), [props.curves]);
    return <div ref={holder} class="plot" role="img" aria-label={props.name} />;
}
