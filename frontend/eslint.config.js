import js from '@eslint/js'
import jsxA11y from 'eslint-plugin-jsx-a11y'
import reactHooks from 'eslint-plugin-react-hooks'
import globals from 'globals'
import tseslint from 'typescript-eslint'

export default tseslint.config(
  { ignores: ['dist', 'node_modules', 'src/api/schema.gen.ts', 'test-results', 'playwright-report'] },
  js.configs.recommended,
  {
    files: ['**/*.{ts,tsx}'],
    extends: [...tseslint.configs.recommendedTypeChecked],
    languageOptions: { parserOptions: { project: './tsconfig.json', tsconfigRootDir: import.meta.dirname } },
    rules: {
      '@typescript-eslint/consistent-type-imports': ['error', { fixStyle: 'inline-type-imports' }],
      '@typescript-eslint/no-misused-promises': ['error', { checksVoidReturn: { attributes: false } }],
      // The router's redirect() and notFound() are thrown values by design.
      '@typescript-eslint/only-throw-error': 'off',
    },
  },
  {
    files: ['src/**/*.{ts,tsx}'],
    ...jsxA11y.flatConfigs.strict,
  },
  {
    files: ['src/**/*.{ts,tsx}'],
    plugins: { 'react-hooks': reactHooks },
    languageOptions: { globals: globals.browser },
    rules: {
      'react-hooks/rules-of-hooks': 'error',
      'react-hooks/exhaustive-deps': 'error',
      'no-console': 'error',
    },
  },
  {
    files: ['src/**/*.{ts,tsx}'],
    ignores: ['src/api/queryKeys.ts', 'src/**/*.test.{ts,tsx}'],
    rules: {
      'no-restricted-syntax': [
        'error',
        ...[
          ':matches(Property[key.name="queryKey"], VariableDeclarator[id.name=/[kK]eys?$/]) > ArrayExpression',
          ':matches(Property[key.name="queryKey"], VariableDeclarator[id.name=/[kK]eys?$/]) > TSAsExpression > ArrayExpression',
          'VariableDeclarator[id.name=/[kK]ey(s|Of)?$/] ArrowFunctionExpression ArrayExpression',
          'CallExpression[callee.property.name=/^(get|set|ensure)Quer(y|ies)(Data|State)$/] > ArrayExpression',
          'CallExpression[callee.name="invalidate"] > ArrayExpression',
        ].map((selector) => ({ selector, message: 'Take the key from src/api/queryKeys.ts, or add it there.' })),
        {
          selector:
            'CallExpression[callee.property.name="invalidateQueries"] Property[shorthand=true][key.name="queryKey"]',
          message: 'Use invalidate(client, …) of src/api/queryKeys.ts.',
        },
      ],
    },
  },
  {
    files: ['src/**/*.{ts,tsx}'],
    ignores: ['src/api/useMutation.ts'],
    rules: {
      'no-restricted-imports': [
        'error',
        {
          name: '@tanstack/react-query',
          importNames: ['useMutation'],
          message: 'Take it from @/api: that one calls its handlers even where the part that asked has gone.',
        },
        {
          name: '@/audio',
          importNames: ['usePlayer'],
          message: 'Use useTakePlayer of @/heard/useTakePlayer, which records what a person hears.',
        },
      ],
    },
  },
  {
    files: ['*.js', '*.cjs', 'scripts/**', 'public/**'],
    languageOptions: { globals: { ...globals.node, ...globals.browser } },
  },
)
